// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_MOTION_BY_FLOW_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_MOTION_BY_FLOW_H

#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/Extent.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/Flow_displacements.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

/*
Computes the displacements of all free vertices if the whole interface follows a flow that is known
everywhere: the free vertices follow the flow, too.

If the flow would move the boundary of the domain, a box, the displacement is scaled down to zero
towards the boundary. The scaling begins at half of the smallest distance between the interface and
the boundary. Returns `nullopt` if the flow is not known everywhere, the interface deviates from the
flow, the boundary is fixed, some inner vertices are not free, or the distance between interface and
boundary is too small for the longest displacement.

`displacement(v)` is the remaining displacement of an interface vertex. `flow` gives the
displacements of vertices by the flow. `longest` is the length of the longest displacement.
Differences up to `negligible` are ignored.
*/
template <class Complex, class Displacement>
std::optional<std::vector<typename Complex::Approximate_vector>>
motion_by_flow(const Complex& complex, const std::vector<typename Complex::Vertex_handle>& free,
               const Displacement& displacement, Flow_displacements<Complex>& flow, double longest,
               double negligible) {
  using Vertex_handle = typename Complex::Vertex_handle;
  using Vector = typename Complex::Approximate_vector;
  static constexpr double fading = .5; // of the distance: cells at the interface keep their shape
  static constexpr double steepest = .125; // longest displacement relative to the fading distance
  const auto is_negligible = [&](const Vector& d) {
    return d.squared_length() <= negligible * negligible;
  };
  if (!flow.is_given())
    return {};
  std::vector<Vertex_handle> boundary, interface_;
  std::size_t number_of_inner = 0;
  for (Vertex_handle v : complex.finite_vertices()) {
    number_of_inner += !v->is_interface() && !complex.is_boundary(v);
    if (complex.is_boundary(v))
      boundary.push_back(v);
    if (v->is_interface())
      interface_.push_back(v);
  }
  if (free.size() != number_of_inner)
    return {};
  Extent<Complex::dimension> box;
  bool fades = false;
  flow.find(boundary);
  for (Vertex_handle v : boundary) {
    box.add(complex.position(v));
    const std::optional<Vector> known = flow(v);
    if (!known || (v->boundary_class() & Boundary_class::fixed) != 0)
      return {};
    fades = fades || !is_negligible(*known);
  }
  const auto distance = [&](Vertex_handle v) {
    double result = std::numeric_limits<double>::infinity();
    const auto p = complex.position(v);
    for (int axis = 0; fades && axis < Complex::dimension; ++axis)
      result = (std::min)({result, p[axis] - box.lower(axis), box.upper(axis) - p[axis]});
    return result;
  };
  double room = std::numeric_limits<double>::infinity();
  flow.find(interface_);
  for (Vertex_handle v : interface_) {
    const std::optional<Vector> known = flow(v);
    if (!known || !is_negligible(displacement(v) - *known))
      return {};
    room = (std::min)(room, distance(v));
    if (longest > steepest * fading * room)
      return {};
  }
  std::vector<Vector> result;
  result.reserve(free.size());
  flow.find(free);
  for (Vertex_handle v : free) {
    const std::optional<Vector> known = flow(v);
    if (!known)
      return {};
    const double reach = distance(v), full = fading * room;
    result.push_back(reach < full ? reach / full * *known : *known);
  }
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_MOTION_BY_FLOW_H
