// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_REPAIR_STOPPING_VISITORS_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_REPAIR_STOPPING_VISITORS_3_H

#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>

#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/alpha_wrap_3.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A visitor that makes a wrap interruptible.
struct Stopping_wrap_visitor : Alpha_wraps_3::internal::Wrapping_default_visitor
{
  template <class Wrap, class Gate> void before_facet_treatment(const Wrap&, const Gate&) {
    Progress_scope::check();
  }
};

// A visitor that makes hole filling interruptible.
struct Stopping_hole_visitor : Polygon_mesh_processing::Hole_filling::Default_visitor
{
  void quadratic_step() const { Progress_scope::check(); }
  void cubic_step() const { Progress_scope::check(); }
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_REPAIR_STOPPING_VISITORS_3_H
