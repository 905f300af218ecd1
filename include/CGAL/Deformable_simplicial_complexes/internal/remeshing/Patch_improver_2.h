// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_REMESHING_PATCH_IMPROVER_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_REMESHING_PATCH_IMPROVER_2_H

#include <CGAL/Deformable_simplicial_complexes/Any_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/For_each_index.h>
#include <CGAL/Deformable_simplicial_complexes/Improvement_report.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// In the plane, any triangulation of a point set can be reached by flips. So there is nothing to
// do.
template <class Complex> class Patch_improver_2
{
public:
  Patch_improver_2(Complex&, Any_visitor<Complex>&, double, unsigned, const For_each_index&) {}
  void run() {}
  Improvement_report report() const { return {}; }
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_REMESHING_PATCH_IMPROVER_2_H
