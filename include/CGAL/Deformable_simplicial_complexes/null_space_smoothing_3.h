// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_NULL_SPACE_SMOOTHING_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_NULL_SPACE_SMOOTHING_3_H

#include <CGAL/Deformable_simplicial_complexes/Vertex_quadric_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/geometry/triangle_quality.h>
#include <CGAL/Deformable_simplicial_complexes/internal/geometry/vectors_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/interface/Interface_fan_3.h>
#include <CGAL/Deformable_simplicial_complexes/vertex_smoothing.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// As propose_null_space_position(), for the center of a fan.
template <class Complex>
bool null_space_position(const Complex& complex, const Interface_fan_3<Complex>& fan,
                         const std::vector<typename Complex::Cell_handle>& star,
                         double aggressiveness, double feature_angle, double minimum_quality,
                         typename Complex::Point& target) {
  using Vector = typename Complex::Approximate_vector_3;
  const auto v = fan.center();
  if (complex.is_boundary(v) || !fan.is_disk())
    return false;

  const auto from = complex.position(v);
  Vertex_quadric_3<Vector> quadric;
  Vector sum_of_areas(0, 0, 0), to_centroids(0, 0, 0);
  double area = 0, worst_facet = 1;
  for (std::size_t i = 0; i < fan.size(); ++i) {
    const auto p = fan.facet(i, from);
    const Vector normal = area_vector(p);
    const double a = std::sqrt(normal.squared_length());
    worst_facet = (std::min)(worst_facet, triangle_quality(p));
    if (!(a > 0))
      continue;
    quadric.add(normal / a, a);
    sum_of_areas = sum_of_areas + normal;
    to_centroids = to_centroids + a * ((p[1] - from) + (p[2] - from)) / 3;
    area += a;
  }
  quadric.analyse(aggressiveness, fan.rank_by_features(feature_angle));
  const double squared_sum = sum_of_areas.squared_length();
  if (quadric.rank() == 3 || !(squared_sum > 0))
    return false;
  Vector step = quadric.project_on_null_space(to_centroids / area);
  step = step - (step * sum_of_areas) / squared_sum * sum_of_areas;

  double worst_cell = std::numeric_limits<double>::infinity();
  for (auto c : star)
    worst_cell = (std::min)(worst_cell, c->quality());
  const double bound = (std::min)(minimum_quality, worst_cell);
  const auto is_better = [&](const typename Complex::Approximate_point_3& p) {
    for (std::size_t i = 0; i < fan.size(); ++i) {
      const auto before = fan.facet(i, from), after = fan.facet(i, p);
      if (!(triangle_quality(after) > worst_facet) ||
          !(area_vector(before) * area_vector(after) > 0))
        return false;
    }
    return star_quality(complex, complex.quality_measure(), v, star, p, 0) >= bound;
  };
  const auto exact = complex.geom_traits().construct_exact_point_3_object();
  for (double part : {1., .5}) {
    const auto p = from + part * step;
    target = exact(p);
    if (is_better(p))
      return complex.is_positive_star(v, star, target);
  }
  return false;
}

} // namespace internal

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to move a vertex of the interface along the interface, towards the mean of the centroids of
its facets, weighted by their areas: within the null space of the quadric of its facets, which is
the tangent plane where the interface is smooth, and the line of a ridge (null-space smoothing,
section 3.2.2 of the paper, after Jiao). Corners stay, and so do vertices on the boundary of the
domain and where the interface is not one sheet between two labels.

The step is also taken to be perpendicular to the sum of the area vectors of the facets, so that the
two labels keep their volumes, up to rounding.

\param complex is not changed.
\param v a vertex of the interface.
\param star the star of v.
\param aggressiveness up to which ratio of the eigenvalues a direction belongs to the null space, in
       [0, 1); the paper takes 0.025. On an edge between two facets of equal areas, that is a
       dihedral angle of 2 atan(sqrt(aggressiveness)): 18 degrees.
\param feature_angle where the normals of two facets differ by more, in radians, v moves only along
       their edge whatever their areas, and not at all where such edges end, meet or turn.
\param minimum_quality no cell of the star may come to be of lower quality, unless it is so already;
       then none may come to be worse than the worst is.
\param target the proposed position.
\return whether there is one: all cells around v being positive, no facet turned over, and the worst
       facet better by the ratio of the area to the squared edges. Commit with
       `complex.set_point(v, star, target)`.

Linear in the star.
*/
template <class Complex>
bool propose_null_space_position(const Complex& complex, typename Complex::Vertex_handle v,
                                 const std::vector<typename Complex::Cell_handle>& star,
                                 double aggressiveness, double feature_angle,
                                 double minimum_quality, typename Complex::Point_3& target) {
  const internal::Interface_fan_3<Complex> fan(complex, v, star);
  return internal::null_space_position(complex, fan, star, aggressiveness, feature_angle,
                                       minimum_quality, target);
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_NULL_SPACE_SMOOTHING_3_H
