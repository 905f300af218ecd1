// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_CHANGED_FACETS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_CHANGED_FACETS_H

#include <CGAL/Deformable_simplicial_complexes/internal/interface/Interface_edge_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/interface/Interface_fan.h>
#include <CGAL/Deformable_simplicial_complexes/internal/operations/triangle_quality.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The change of the interface facets by an operation.
struct Changed_facets
{
  double worst_before = std::numeric_limits<double>::infinity(); // quality of a facet
  double worst_after = std::numeric_limits<double>::infinity();  // 0 if a facet is inverted
  double swept_volume = 0; // volume between the interface before and after; in the plane, area
};

// Returns the change of the facets of a fan when its center is collapsed into a neighbor.
template <class Complex>
Changed_facets facets_changed_by_collapse(const Complex& complex,
                                          const Interface_fan_3<Complex>& fan,
                                          typename Complex::Vertex_handle kept) {
  const auto from = complex.position(fan.center()), to = complex.position_near(from, kept);
  Changed_facets result;
  for (std::size_t i = 0; i < fan.size(); ++i) {
    const auto before = fan.facet(i, from);
    result.worst_before = (std::min)(result.worst_before, triangle_quality(before));
    if (fan.has_neighbor(i, kept))
      continue; // the facet is removed
    const auto after = fan.facet(i, to);
    const bool turns_over = !(area_vector(before) * area_vector(after) > 0);
    result.worst_after = (std::min)(result.worst_after, turns_over ? 0 : triangle_quality(after));
    result.swept_volume += std::abs((to - from) * area_vector(before)) / 3;
  }
  return result;
}

// Returns the change of the two facets at an edge when the edge is flipped.
// \pre edge.is_in_sheet()
template <class Complex>
Changed_facets facets_changed_by_flip(const Interface_edge_3<Complex>& edge) {
  Changed_facets result;
  for (int i = 0; i < 2; ++i) {
    result.worst_before = (std::min)(result.worst_before, triangle_quality(edge.facet(i)));
    result.worst_after = (std::min)(result.worst_after, triangle_quality(edge.flipped_facet(i)));
  }
  // The two flipped facets traverse their common edge in opposite directions. The pair is folded
  // over if their normals are not on the same side.
  if (!(area_vector(edge.flipped_facet(0)) * area_vector(edge.flipped_facet(1)) > 0))
    result.worst_after = 0;
  const auto p = edge.flipped_facet(0);
  result.swept_volume = std::abs((edge.flipped_facet(1)[0] - p[0]) * area_vector(p)) / 3;
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_CHANGED_FACETS_H
