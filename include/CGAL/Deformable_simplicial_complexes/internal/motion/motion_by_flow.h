// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_MOTION_BY_FLOW_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_MOTION_BY_FLOW_H

#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/Extent.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

/*
How all free vertices go if the whole interface goes with a flow of space that is known everywhere:
with it, too. If it would take along the boundary of the domain, a box, it fades towards that, but
not before half-way between the boundary and the interface where that is nearest to it. Nothing if
that is not so, or there is too little room to fade.

`way(v)` is what a vertex of the interface has before it, the longest way is known; `flow(v)` where
any vertex is taken by the flow; differences below a length count as none.
*/
template <class Complex, class Way, class Flow>
std::optional<std::vector<typename Complex::Approximate_vector>>
motion_by_flow(const Complex& complex, const std::vector<typename Complex::Vertex_handle>& free,
               const Way& way, const Flow& flow, double longest, double negligible) {
  using Vertex_handle = typename Complex::Vertex_handle;
  using Vector = typename Complex::Approximate_vector;
  static constexpr double fading = .5;     // of the room: cells at the interface keep their shape
  static constexpr double steepest = .125; // the longest way over that part of the room
  const auto is_negligible = [&](const Vector& d) {
    return d.squared_length() <= negligible * negligible;
  };
  Extent<Complex::dimension> box;
  std::size_t number_of_inner = 0;
  bool fades = false;
  for (Vertex_handle v : complex.finite_vertices()) {
    number_of_inner += !v->is_interface() && !complex.is_boundary(v);
    if (!complex.is_boundary(v))
      continue;
    box.add(complex.position(v));
    const std::optional<Vector> known = flow(v);
    if (!known || (v->boundary_class() & Boundary_class::fixed) != 0)
      return {};
    fades = fades || !is_negligible(*known);
  }
  if (free.size() != number_of_inner)
    return {};
  const auto distance = [&](Vertex_handle v) {
    double result = std::numeric_limits<double>::infinity();
    const auto p = complex.position(v);
    for (int axis = 0; fades && axis < Complex::dimension; ++axis)
      result = (std::min)({result, p[axis] - box.lower(axis), box.upper(axis) - p[axis]});
    return result;
  };
  double room = std::numeric_limits<double>::infinity();
  for (Vertex_handle v : complex.finite_vertices()) {
    if (!v->is_interface())
      continue;
    const std::optional<Vector> known = flow(v);
    if (!known || !is_negligible(way(v) - *known))
      return {};
    room = (std::min)(room, distance(v));
    if (longest > steepest * fading * room)
      return {};
  }
  std::vector<Vector> result;
  result.reserve(free.size());
  for (Vertex_handle v : free) {
    const std::optional<Vector> known = flow(v);
    if (!known)
      return {};
    const double reach = distance(v), full = fading * room;
    result.push_back(reach < full ? reach / full * *known : *known);
  }
  return result;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_MOTION_BY_FLOW_H
