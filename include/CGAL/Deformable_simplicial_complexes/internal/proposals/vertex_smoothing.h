// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_VERTEX_SMOOTHING_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_VERTEX_SMOOTHING_H

#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Marks.h>
#include <CGAL/Deformable_simplicial_complexes/internal/operations/Star_optimizer.h>

#include <CGAL/Origin.h>

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
                             std::vector<typename Complex::Vector_3>& blocked) {
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

namespace CGAL::Deformable_simplicial_complexes {

template <class Complex>
bool propose_optimal_position(const Complex& complex, typename Complex::Vertex_handle v,
                              const std::vector<typename Complex::Cell_handle>& star,
                              typename Complex::Point_3& target) {
  std::vector<typename Complex::Vector_3> blocked;
  if (complex.is_boundary(v) ||
      (v->is_interface() && !internal::find_blocked_directions(complex, star, v, blocked)))
    return false;
  const auto from = complex.position(v);
  internal::Star_optimizer<Complex> optimizer(complex, complex.quality_measure(), v, star);
  for (const auto& direction : blocked)
    optimizer.block(direction);
  const auto to = optimizer.run();
  if (to == from)
    return false;
  target = to;
  return complex.is_positive_star(v, star, target);
}

namespace internal {

// Returns the worst quality of a star, for any measure, with its vertex v at p. Stops at the first
// cell whose quality is not above `bound`.
template <class Complex, class Measure>
double star_quality(const Complex& complex, const Measure& measure,
                    typename Complex::Vertex_handle v,
                    const std::vector<typename Complex::Cell_handle>& star,
                    const typename Complex::Point& p, double bound) {
  double worst = std::numeric_limits<double>::infinity();
  for (auto c : star) {
    if (complex.is_infinite(c))
      continue;
    worst = (std::min)(worst, complex.domain().template apply<Complex>(measure, [&](int i) {
      const auto w = c->vertex(i);
      return w == v ? p : complex.position(w);
    }));
    if (!(worst > bound))
      break;
  }
  return worst;
}

} // namespace internal

template <class Complex>
bool propose_smart_laplacian(const Complex& complex, typename Complex::Vertex_handle v,
                             const std::vector<typename Complex::Cell_handle>& star,
                             typename Complex::Point& target) {
  if (v->is_interface())
    return false;
  using Vector = typename Complex::Vector;
  internal::Marks seen = internal::vertex_marks(complex);
  std::size_t number = 0; // number of neighbors
  const auto from = complex.position(v);
  Vector sum(CGAL::NULL_VECTOR);
  double worst = std::numeric_limits<double>::infinity();
  for (auto c : star) {
    if (complex.is_infinite(c))
      continue;
    worst = (std::min)(worst, c->quality());
    for (int i = 0; i < Complex::corners; ++i) {
      const auto w = c->vertex(i);
      if (w == v || !seen.add(w))
        continue;
      ++number;
      sum = sum + (complex.position_near(from, w) - CGAL::ORIGIN);
    }
  }
  const auto to = CGAL::ORIGIN + sum / double(number);
  for (double step : {1., .5}) {
    target = complex.admissible_destination(v, from + step * (to - from));
    if (internal::star_quality(complex, complex.quality_measure(), v, star, target, worst) > worst)
      return complex.is_positive_star(v, star, target);
  }
  return false;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_VERTEX_SMOOTHING_H
