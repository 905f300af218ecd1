// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_INTERFACE_BENDS_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_INTERFACE_BENDS_3_H

#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/interface_triangles_3.h>

#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

template <class Complex> struct Interface_bends_3
{
  using Points = std::vector<typename Complex::Approximate_point_3>;

  static auto normals(const Interface_snapshot<Complex>& interface_, const Points& positions) {
    return vertex_normals(interface_, positions);
  }
  static auto on_features(const Interface_snapshot<Complex>& interface_, const Points& positions,
                          double angle) {
    return vertices_on_features(interface_, positions, angle);
  }
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_INTERFACE_BENDS_3_H
