// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_COLLISION_ORDER_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_COLLISION_ORDER_H

#include <CGAL/Deformable_simplicial_complexes/internal/destinations/Destinations.h>

#include <CGAL/Exact_rational.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the fraction of the displacement of a vertex at which a cell of its star first becomes
// flat, if nothing else moves. The fraction is computed exactly for points with coordinates of type
// `double`. Returns at least 1 if the vertex can reach its destination.
template <class Complex>
Exact_rational first_collision(const Complex& complex, const Destinations<Complex>& destinations,
                               typename Complex::Vertex_handle v,
                               const std::vector<typename Complex::Cell_handle>& star) {
  using Point = typename Complex::Point;
  static constexpr int d = Complex::dimension;
  const Point from = complex.position(v),
              to = complex.domain().nearest_image(from, destinations.final_position(v));
  Exact_rational first = 1;
  for (auto c : star) {
    if (complex.is_infinite(c))
      continue;
    const int apex = c->index(v);
    std::array<Point, d> link;
    for (int i = 0; i < d; ++i)
      link[i] = complex.position_near(from, c->vertex(Complex::Space::facet_vertices[apex][i]));
    const auto measure_with = [&](const Point& p) {
      return Complex::Space::template determinant<Exact_rational>(
          [&](int row, int column) -> Exact_rational {
            return Exact_rational(link[row][column]) - Exact_rational(p[column]);
          });
    };
    // The measure of a cell is linear in the displacement of one vertex.
    const Exact_rational here = measure_with(from), there = measure_with(to);
    if (CGAL::sign(there) != CGAL::sign(here))
      first = (std::min)(first, Exact_rational(here / (here - there)));
  }
  return first;
}

// Sorts vertices by the fraction of their first collision. The sort is stable.
template <class Complex>
void sort_by_first_collision(const Complex& complex, const Destinations<Complex>& destinations,
                             std::vector<typename Complex::Vertex_handle>& vertices) {
  std::vector<std::pair<Exact_rational, std::size_t>> collisions;
  std::vector<typename Complex::Cell_handle> star;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    complex.star(vertices[i], star);
    collisions.emplace_back(first_collision(complex, destinations, vertices[i], star), i);
  }
  std::sort(collisions.begin(), collisions.end());
  std::vector<typename Complex::Vertex_handle> result;
  for (const auto& collision : collisions)
    result.push_back(vertices[collision.second]);
  vertices.swap(result);
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_COLLISION_ORDER_H
