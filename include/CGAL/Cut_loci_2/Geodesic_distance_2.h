// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Cut_loci_2, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CUT_LOCI_2_GEODESIC_DISTANCE_2_H
#define CGAL_CUT_LOCI_2_GEODESIC_DISTANCE_2_H

#include <CGAL/license/Cut_loci_2.h>

#include <CGAL/Cut_loci_2/Geodesic_front_2.h>
#include <CGAL/Cut_loci_2/internal/geodesics/Geodesic_finder_2.h>

#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgCutLoci2Ref

The distance function of a point of a Riemannian 2-manifold, in its chart. The distance of a point
is the length of its shortest geodesic, among the geodesics that a front has followed.

\tparam Metric model of `RiemannianMetric_2`
*/
template <class Metric> class Geodesic_distance_2
{
public:
  using Front = Geodesic_front_2<Metric>;  ///< the type of the front
  using Point_2 = typename Front::Point_2; ///< a point of the chart

  /*!
  Prepares the distance function of a front. It integrates the geodesics of all vertices of the
  front again, which takes about as long as the motion of the front.

  \param front the front. It must have passed all points whose distances are needed, or it must have
         stopped everywhere.

  \throws Error if the metric is not positive definite on a geodesic.
  \throws Interrupted_error if a callback of a `Progress_scope` returned `false`.
  */
  explicit Geodesic_distance_2(Front front)
      : m_front(std::make_shared<Front>(std::move(front))), m_finder(*m_front) {
    static constexpr double difference = 1e-5; // in radians
    const double step = m_front->longest_step();
    for (auto v : m_front->complex().interface_vertices()) {
      const auto& ray = m_front->ray(v);
      const int number = int(std::ceil(ray.length / step));
      const double part = ray.length / number;
      auto state = m_front->shoot(ray.angle, part),
           next = m_front->shoot(ray.angle + difference, part);
      for (int k = 1; k <= number; ++k) {
        if (k > 1) {
          state = m_front->continue_ray(state, part);
          next = m_front->continue_ray(next, part);
        }
        if (m_front->is_in_chart(state))
          m_finder.add({{ray.angle, k * part},
                        state,
                        {(next[0] - state[0]) / difference, (next[1] - state[1]) / difference},
                        {state[2], state[3]}});
      }
    }
  }

  /// Returns the distance of a point of the chart, with an error of about 1e-9 of the width of the
  /// chart. Returns infinity if the front did not come near the point. The function integrates some
  /// geodesics to the point.
  /// \throws Error if the metric is not positive definite on a geodesic.
  double operator()(const Point_2& p) const {
    // Near the source, one geodesic leads to the point. A flat metric gives a good initial guess.
    static constexpr double near = 3, at_source = 1e-6; // in spacings
    const auto straight = m_front->departure(p);
    const double spacing = m_front->length_of_spacing();
    if (straight.length <= at_source * spacing)
      return straight.length;
    if (straight.length < near * spacing)
      if (const auto found = m_finder.geodesic_to(p, {straight.angle, straight.length}))
        return found->length;
    const auto geodesics = m_finder.geodesics_to(p, 1, {});
    return geodesics.empty() ? std::numeric_limits<double>::infinity() : geodesics[0].length;
  }

  /// Returns the front.
  const Front& front() const { return *m_front; }

private:
  std::shared_ptr<const Front> m_front; // shared by copies
  internal::Geodesic_finder_2<Front> m_finder;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_CUT_LOCI_2_GEODESIC_DISTANCE_2_H
