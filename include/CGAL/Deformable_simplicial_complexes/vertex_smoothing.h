// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_VERTEX_SMOOTHING_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_VERTEX_SMOOTHING_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Marks.h>

#include <CGAL/Origin.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// Returns the worst quality of a star, for any measure, with its vertex v at p. Stops at the first
// cell whose quality is not above `bound`.
template <class Complex, class Measure>
double star_quality(const Complex& complex, const Measure& measure,
                    typename Complex::Vertex_handle v,
                    const std::vector<typename Complex::Cell_handle>& star,
                    const typename Complex::Approximate_point& p, double bound) {
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

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to move a vertex towards the barycenter of its neighbors (smart Laplacian smoothing,
section 3.2 of the paper). The vertex moves to the barycenter, or half of the displacement, if this
raises the worst quality of its star. Linear in the star.

\param complex the complex; it is not changed
\param v a vertex that is not on the interface; a vertex on the boundary of the domain stays within
       its sides
\param star the star of v
\param target the proposed position
\return whether there is a proposal; commit with `complex.set_point(v, star, target)`
*/
template <class Complex>
bool propose_smart_laplacian(const Complex& complex, typename Complex::Vertex_handle v,
                             const std::vector<typename Complex::Cell_handle>& star,
                             typename Complex::Point& target) {
  if (v->is_interface())
    return false;
  using Vector = typename Complex::Approximate_vector;
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
    target = complex.admissible_destination(v, complex.exact(from + step * (to - from)));
    if (internal::star_quality(complex, complex.quality_measure(), v, star,
                               complex.approximate(target), worst) > worst)
      return complex.is_positive_star(v, star, target);
  }
  return false;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_VERTEX_SMOOTHING_H
