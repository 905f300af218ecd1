// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_VERTEX_SMOOTHING_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_VERTEX_SMOOTHING_3_H

#include <CGAL/Origin.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {

namespace Deformable_simplicial_complexes {
namespace internal {

// Worst quality of a star, by any measure, if its vertex v were at p; stops at the first cell not
// above `bound`.
template <class Complex, class Measure>
double star_quality(const Complex& complex, const Measure& measure,
                    typename Complex::Vertex_handle v,
                    const std::vector<typename Complex::Cell_handle>& star,
                    const typename Complex::Approximate_point_3& p, double bound) {
  double worst = std::numeric_limits<double>::infinity();
  for (auto c : star) {
    if (complex.is_infinite(c))
      continue;
    const auto point = [&](int i) {
      return c->vertex(i) == v ? p : complex.position(c->vertex(i));
    };
    worst = (std::min)(worst, measure(point(0), point(1), point(2), point(3)));
    if (!(worst > bound))
      break;
  }
  return worst;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Proposes to move a vertex towards the barycenter of its neighbors (smart Laplacian smoothing,
section 3.2 of the paper): all the way, else half of it, if that raises the worst quality of its
star.

\param complex is not changed.
\param v a vertex that is not on the interface; on the boundary of the domain it stays within its
       sides.
\param star the star of v.
\param target the proposed position.
\return whether there is one; commit with `complex.set_point(v, star, target)`.

Linear in the star.
*/
template <class Complex>
bool propose_smart_laplacian(const Complex& complex, typename Complex::Vertex_handle v,
                             const std::vector<typename Complex::Cell_handle>& star,
                             typename Complex::Point_3& target) {
  if (v->is_interface())
    return false;
  using Vector = typename Complex::Approximate_vector_3;
  std::vector<typename Complex::Vertex_handle> neighbors;
  Vector sum(0, 0, 0);
  double worst = std::numeric_limits<double>::infinity();
  for (auto c : star) {
    if (complex.is_infinite(c))
      continue;
    worst = (std::min)(worst, c->quality());
    for (int i = 0; i < 4; ++i) {
      const auto w = c->vertex(i);
      const auto known = w->scratch_index();
      if (w == v || (known < neighbors.size() && neighbors[known] == w))
        continue;
      w->set_scratch_index(std::uint32_t(neighbors.size()));
      neighbors.push_back(w);
      sum = sum + (complex.position(w) - CGAL::ORIGIN);
    }
  }
  const auto from = complex.position(v);
  const auto to = CGAL::ORIGIN + sum / double(neighbors.size());
  const auto exact = complex.geom_traits().construct_exact_point_3_object();
  const auto approximate = complex.geom_traits().construct_approximate_point_3_object();
  for (double step : {1., .5}) {
    target = complex.admissible_destination(v, exact(from + step * (to - from)));
    if (Deformable_simplicial_complexes::internal::star_quality(
            complex, complex.quality_measure(), v, star, approximate(target), worst) > worst)
      return complex.is_positive_star(v, star, target);
  }
  return false;
}

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_VERTEX_SMOOTHING_3_H
