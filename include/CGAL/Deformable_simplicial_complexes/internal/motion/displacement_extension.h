// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_DISPLACEMENT_EXTENSION_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_DISPLACEMENT_EXTENSION_H

#include <CGAL/Deformable_simplicial_complexes/For_each_index.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/Less_time_stamp.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/Flow_displacements.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/Harmonic_extension.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/motion_by_flow.h>

#include <CGAL/Origin.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

/*
Computes the displacements of free vertices from the displacement of the interface.

Free vertices at which the flow is known follow the flow; their deviation from it is the harmonic
extension of the deviation of the interface and the boundary. The other free vertices get the
harmonic extension of the displacements around them.

`displacement(v)` is the remaining displacement of an interface vertex, and zero for boundary
vertices. `flow` gives the displacements of vertices by the flow, where it is known. `longest` is
the length of the longest displacement.
*/
template <class Complex, class Displacement>
std::vector<typename Complex::Approximate_vector>
displacement_extension(const Complex& complex,
                       const std::vector<typename Complex::Vertex_handle>& free,
                       const Displacement& displacement, Flow_displacements<Complex>& flow,
                       double longest, const For_each_index& for_each_index) {
  using Vertex_handle = typename Complex::Vertex_handle;
  using Vector = typename Complex::Approximate_vector;
  static constexpr double part = 1e-6; // relative to the longest displacement
  const double negligible = part * longest;
  if (auto followed = motion_by_flow(complex, free, displacement, flow, longest, negligible))
    return *std::move(followed);
  std::vector<Vertex_handle> guided, others;
  flow.find(free);
  std::vector<Vector> flows; // displacements of guided vertices by the flow
  for (Vertex_handle v : free)
    if (const std::optional<Vector> known = flow(v)) {
      guided.push_back(v);
      flows.push_back(*known);
    } else {
      others.push_back(v);
    }
  flow.find(vertices_around(complex, guided));
  const auto is_free = [](Vertex_handle v, const std::vector<Vertex_handle>& list) {
    return std::binary_search(list.begin(), list.end(), v, Less_time_stamp());
  };
  const Harmonic_extension<Complex> to_others(
      complex, others,
      [&](Vertex_handle v) { return is_free(v, guided) ? *flow(v) : displacement(v); },
      for_each_index);
  const Harmonic_extension<Complex> to_guided(
      complex, guided,
      [&](Vertex_handle v) {
        const std::optional<Vector> known = flow(v);
        if (!known || is_free(v, others))
          return Vector(CGAL::NULL_VECTOR);
        const Vector d = displacement(v) - *known;
        return d.squared_length() < negligible * negligible ? Vector(CGAL::NULL_VECTOR) : d;
      },
      for_each_index);
  const std::vector<Vector> of_others = to_others.solve(), deviations = to_guided.solve();
  std::vector<Vector> result;
  std::size_t g = 0, o = 0;
  for (Vertex_handle v : free)
    if (g < guided.size() && guided[g] == v) {
      result.push_back(flows[g] + deviations[g]);
      ++g;
    } else {
      result.push_back(of_others[o++]);
    }
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_DISPLACEMENT_EXTENSION_H
