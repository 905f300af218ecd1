// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Interface_remeshing, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_REMESHING_INTERNAL_INTERFACE_INTERFACE_BENDS_H
#define CGAL_INTERFACE_REMESHING_INTERNAL_INTERFACE_INTERFACE_BENDS_H

#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/internal/interface/Interface_fan.h>
#include <CGAL/Interface_remeshing/interface_triangles_3.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

template <class Complex> struct Interface_bends_2
{
  using Points = std::vector<typename Complex::Approximate_point>;
  using Vector = typename Complex::Approximate_vector;

  // Returns the unit normals at the vertices of a curve: the normal of the circle through a vertex
  // and its two neighbors.
  static std::vector<Vector> normals(const Interface_snapshot<Complex>& interface_,
                                     const Points& positions) {
    std::vector<Vector> result(positions.size(), Vector(0, 0));
    for_each_side(interface_, positions, [&](std::size_t v, const Vector& edge) {
      // The normal of the circle is the sum of the edge normals, each divided by its edge length.
      result[v] = result[v] + Vector(edge.y(), -edge.x()) / edge.squared_length();
    });
    static constexpr double rounding = 1e-9; // relative to the sum of weights
    std::vector<double> weights(positions.size(), 0);
    for_each_side(interface_, positions, [&](std::size_t v, const Vector& edge) {
      weights[v] += 1 / std::sqrt(edge.squared_length());
    });
    for (std::size_t v = 0; v < result.size(); ++v) {
      const double length = std::sqrt(result[v].squared_length());
      result[v] = length > rounding * weights[v] ? result[v] / length : Vector(0, 0);
    }
    return result;
  }

  static std::vector<char> on_features(const Interface_snapshot<Complex>& interface_,
                                       const Points& positions, double angle) {
    std::vector<char> result(positions.size(), false);
    std::vector<Vector> first(positions.size(), Vector(0, 0));
    for_each_side(interface_, positions, [&](std::size_t v, const Vector& edge) {
      if (first[v] == Vector(0, 0))
        first[v] = edge;
      else
        result[v] = result[v] || turn_between(first[v], edge) > angle;
    });
    return result;
  }

private:
  // Calls a function for each vertex with each incident edge, directed so that the larger label is
  // on the left.
  template <class Function>
  static void for_each_side(const Interface_snapshot<Complex>& interface_, const Points& positions,
                            const Function& function) {
    for (const auto& segment : interface_.segments) {
      const auto& p = positions[segment.vertices[0]];
      const Vector edge = interface_.domain.near(p, positions[segment.vertices[1]]) - p;
      if (edge.squared_length() > 0)
        for (std::size_t v : segment.vertices)
          function(v, edge);
    }
  }
};

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

/*
The bending of the interface of a snapshot at its vertices. In each dimension:

- `normals(snapshot, positions)`: the unit normals, out of the larger label; 0 where the facet
  normals cancel each other
- `on_features(snapshot, positions, angle)`: for each vertex, whether the normals of two incident
  facets differ by more than `angle`, in radians
*/
template <class Complex>
using Interface_bends = std::conditional_t<Complex::dimension == 2, Interface_bends_2<Complex>,
                                           Interface_bends_3<Complex>>;

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INTERFACE_REMESHING_INTERNAL_INTERFACE_INTERFACE_BENDS_H
