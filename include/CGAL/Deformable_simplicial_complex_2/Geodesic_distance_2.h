// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_GEODESIC_DISTANCE_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_GEODESIC_DISTANCE_2_H

#include <CGAL/Deformable_simplicial_complex_2/Geodesic_front_2.h>
#include <CGAL/Deformable_simplicial_complex_2/internal/geodesics/Geodesic_finder_2.h>

#include <limits>
#include <memory>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

The distance field of a point of a Riemannian 2-manifold, in its chart: the lengths of the shortest
geodesics that a front has followed.

\tparam Metric model of `RiemannianMetric_2`
*/
template <class Metric> class Geodesic_distance_2
{
public:
  using Front = Geodesic_front_2<Metric>;  ///< the front
  using Point_2 = typename Front::Point_2; ///< of the chart

  /*!
  \param front has gone as far as distances are asked for, or until all of it has stopped

  Follows the rays of the front's vertices anew: the time is that of the front's own integration.

  \throws Deformable_simplicial_complexes::Error if the metric is not positive on the way of one
  */
  explicit Geodesic_distance_2(Front front)
      : m_front(std::make_shared<Front>(std::move(front))), m_finder(*m_front) {
    static constexpr double difference = 1e-5; // radians
    const double step = 2 * m_front->step();
    for (auto v : m_front->complex().interface_vertices()) {
      const auto& ray = m_front->ray(v);
      if (!(step > 0))
        break;
      auto state = m_front->shoot(ray.angle, step),
           next = m_front->shoot(ray.angle + difference, step);
      for (double length = step; length <= ray.length; length += step) {
        if (length > step) {
          state = m_front->continue_ray(state, step);
          next = m_front->continue_ray(next, step);
        }
        if (m_front->is_in_chart(state))
          m_finder.add({{ray.angle, length},
                        state,
                        {(next[0] - state[0]) / difference, (next[1] - state[1]) / difference},
                        {state[2], state[3]}});
      }
    }
  }

  /// The distance of a point of the chart, to about 1e-9; infinity if the front did not come near.
  /// Takes the integration of some geodesics to it.
  double operator()(const Point_2& p) const {
    if (m_front->length_near_source(p) == 0)
      return 0;
    const auto geodesics = m_finder.geodesics_to(p, 1, {});
    return geodesics.empty() ? std::numeric_limits<double>::infinity() : geodesics[0].length;
  }

  /// The front that it was made of.
  const Front& front() const { return *m_front; }

private:
  std::shared_ptr<const Front> m_front; // copies share it
  Deformable_simplicial_complexes::internal::Geodesic_finder_2<Front> m_finder;
};

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_GEODESIC_DISTANCE_2_H
