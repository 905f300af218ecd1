// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_COLLISION_ORDER_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_COLLISION_ORDER_3_H

#include <CGAL/Exact_rational.h>
#include <CGAL/determinant.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// The fraction of the way of a vertex to its destination at which its star first has a flat cell,
// if nothing else moves: rational, without rounding, for points with coordinates of type `double`.
// At least 1 if it can go all the way.
template <class Complex>
Exact_rational first_collision(const Complex& complex, typename Complex::Vertex_handle v,
                               const std::vector<typename Complex::Cell_handle>& star) {
  using Point = typename Complex::Approximate_point_3;
  const auto volume = [](const Point& a, const Point& b, const Point& c, const Point& d) {
    const auto difference = [&](const Point& p, int i) -> Exact_rational {
      return Exact_rational(p[i]) - Exact_rational(d[i]);
    };
    return CGAL::determinant<Exact_rational>(difference(a, 0), difference(a, 1), difference(a, 2),
                                             difference(b, 0), difference(b, 1), difference(b, 2),
                                             difference(c, 0), difference(c, 1), difference(c, 2));
  };
  Exact_rational first = 1;
  for (auto c : star) {
    if (complex.is_infinite(c))
      continue;
    const auto f = complex.facet_vertices(std::make_pair(c, c->index(v)));
    const Point p = complex.position(f[0]), q = complex.position(f[1]), r = complex.position(f[2]);
    // Volumes are linear along the way.
    const Exact_rational here = volume(p, q, r, complex.position(v)),
                         there = volume(p, q, r, complex.final_position(v));
    if (CGAL::sign(there) != CGAL::sign(here))
      first = (std::min)(first, Exact_rational(here / (here - there)));
  }
  return first;
}

// Sorts vertices by their first collisions; those that collide at the same time keep their order.
template <class Complex>
void sort_by_first_collision(const Complex& complex,
                             std::vector<typename Complex::Vertex_handle>& vertices) {
  std::vector<std::pair<Exact_rational, std::size_t>> collisions;
  std::vector<typename Complex::Cell_handle> star;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    complex.star(vertices[i], star);
    collisions.emplace_back(first_collision(complex, vertices[i], star), i);
  }
  std::sort(collisions.begin(), collisions.end());
  std::vector<typename Complex::Vertex_handle> result;
  for (const auto& collision : collisions)
    result.push_back(vertices[collision.second]);
  vertices.swap(result);
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_COLLISION_ORDER_3_H
