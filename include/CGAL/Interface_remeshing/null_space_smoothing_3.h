// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_NULL_SPACE_SMOOTHING_3_H
#define CGAL_INTERFACE_REMESHING_NULL_SPACE_SMOOTHING_3_H

#include <CGAL/Deformable_simplicial_complexes/internal/interface/Interface_fan.h>
#include <CGAL/Deformable_simplicial_complexes/internal/operations/triangle_quality.h>
#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>
#include <CGAL/Interface_remeshing/Vertex_quadric_3.h>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// Proposes a position for the center of a fan, see `propose_null_space_position()`.
template <class Complex>
bool null_space_position(const Complex& complex, const Interface_fan_3<Complex>& fan,
                         const std::vector<typename Complex::Cell_handle>& star,
                         double aggressiveness, double feature_angle, double minimum_quality,
                         typename Complex::Point& target) {
  using Vector = typename Complex::Vector_3;
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
  const auto is_better = [&](const typename Complex::Point_3& p) {
    for (std::size_t i = 0; i < fan.size(); ++i) {
      const auto before = fan.facet(i, from), after = fan.facet(i, p);
      if (!(triangle_quality(after) > worst_facet) ||
          !(area_vector(before) * area_vector(after) > 0))
        return false;
    }
    return star_quality(complex, complex.quality_measure(), v, star, p, 0) >= bound;
  };
  for (double part : {1., .5}) {
    const auto p = from + part * step;
    target = p;
    if (is_better(p))
      return complex.is_positive_star(v, star, target);
  }
  return false;
}

} // namespace internal

/*!
\ingroup PkgInterfaceRemeshingRef

Proposes to move a vertex along the interface (null-space smoothing, section 3.2.2 of the paper,
after \cgalCite{cgal:j-fouae-07}). It moves towards the area-weighted mean of the centroids of its
facets. The displacement is projected on the null space of the quadric of the facets. The null space
is the tangent plane where the interface is smooth, and the line of a ridge. Corners, vertices on
the boundary of the domain, and vertices where the interface is not a single sheet between two
labels stay. Linear in the star.

The displacement is also perpendicular to the sum of the area vectors of the facets, so that the
volumes of the two labels stay the same, up to rounding.

\param complex the complex; it is not changed
\param v a vertex of the interface
\param star the star of v
\param aggressiveness largest ratio of the eigenvalues for which a direction belongs to the null
       space, in [0, 1); the paper uses 0.025. On an edge between two facets of equal areas, a ratio
       corresponds to a dihedral angle of 2 atan(sqrt(aggressiveness)): 18 degrees for 0.025.
\param feature_angle an edge is a feature if the normals of its two facets differ by a larger angle,
       in radians. v then moves only along feature edges, for any areas, and stays where such edges
       end, meet or turn.
\param minimum_quality lower bound of the quality of the cells of the star. If the worst cell is
       below the bound already, its quality is the bound.
\param target the proposed position
\return whether there is a proposal: all cells around v stay positively oriented, no facet is turned
        over, and the worst facet improves, measured by the ratio of area to squared edge lengths.
        Commit with `complex.set_point(v, star, target)`.
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

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_NULL_SPACE_SMOOTHING_3_H
