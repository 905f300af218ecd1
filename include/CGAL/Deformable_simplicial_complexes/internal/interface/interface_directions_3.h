// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_INTERFACE_DIRECTIONS_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_INTERFACE_DIRECTIONS_3_H

#include <cmath>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Computes orthogonal directions in which a vertex must not move, so that the interface does not
// change. There is no such direction off the interface, one where the interface is flat, and two
// where all facets share a line. Returns false if the vertex must not move at all. Two planes count
// as equal if the sine of the angle between them is at most 1e-7, which is above the rounding
// errors of moved vertices.
template <class Complex>
bool find_blocked_directions(const Complex& complex,
                             const std::vector<typename Complex::Cell_handle>& star,
                             typename Complex::Vertex_handle v,
                             std::vector<typename Complex::Approximate_vector_3>& blocked) {
  static constexpr double same = 1e-7; // sine of the angle between two planes
  blocked.clear();
  for (auto c : star)
    for (int i = 0; i < 4; ++i) {
      const std::pair<typename Complex::Cell_handle, int> facet(c, i);
      if (c->vertex(i) == v || !complex.is_interface(facet))
        continue;
      const auto w = complex.facet_vertices(facet);
      auto normal =
          cross_product(complex.displacement(w[0], w[1]), complex.displacement(w[0], w[2]));
      const double area = std::sqrt(normal.squared_length());
      if (!(area > 0))
        return false;
      normal = normal / area;
      for (const auto& direction : blocked)
        normal = normal - (normal * direction) * direction;
      const double rest = std::sqrt(normal.squared_length());
      if (rest <= same)
        continue;
      if (blocked.size() == 2)
        return false;
      blocked.push_back(normal / rest);
    }
  return true;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_INTERFACE_DIRECTIONS_3_H
