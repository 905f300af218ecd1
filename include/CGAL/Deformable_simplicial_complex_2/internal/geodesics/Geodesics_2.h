// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_GEODESICS_GEODESICS_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_GEODESICS_GEODESICS_2_H

#include <CGAL/Deformable_simplicial_complex_2/Riemannian_metric_2.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>

#include <boost/numeric/odeint.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// A point of a chart and the velocity of the geodesic there: u, v, u', v'.
using Geodesic_state = std::array<double, 4>;

// The geodesics from a point of a chart, of unit speed.
template <class Metric> class Geodesics_2
{
public:
  Geodesics_2(const Metric& metric, double u, double v) : m_metric(metric), m_u(u), m_v(v) {
    const Metric_jet_2 g = metric(u, v);
    const double determinant = g.E * g.G - g.F * g.F;
    if (!(g.E > 0 && determinant > 0) || !std::isfinite(determinant))
      throw Error("the metric is not positive at the point: choose another one, or a chart that is "
                  "regular there");
    m_first = {1 / std::sqrt(g.E), 0};
    const double second = std::sqrt(g.E / determinant);
    m_second = {-g.F / g.E * second, second};
  }

  // The beginning of a geodesic, by its angle from that along u, in radians.
  Geodesic_state begin(double angle) const {
    const double c = std::cos(angle), s = std::sin(angle);
    return {m_u, m_v, c * m_first[0] + s * m_second[0], c * m_first[1] + s * m_second[1]};
  }

  // Where a geodesic is after another length. Throws Error where the metric is not positive.
  Geodesic_state advance(const Geodesic_state& start, double length) const {
    namespace odeint = boost::numeric::odeint;
    static constexpr double tolerance = 1e-11, first_step = .2, last_step = 1e-5; // of the length
    if (length == 0)
      return start;
    const auto derivative = [this](const Geodesic_state& x, Geodesic_state& dx, double) {
      const Metric_jet_2 g = m_metric(x[0], x[1]);
      const double p = x[2], q = x[3];
      const double a = -(g.E_u / 2 * p * p + g.E_v * p * q + (g.F_v - g.G_u / 2) * q * q),
                   b = -((g.F_u - g.E_v / 2) * p * p + g.G_u * p * q + g.G_v / 2 * q * q),
                   determinant = g.E * g.G - g.F * g.F;
      dx = {p, q, (g.G * a - g.F * b) / determinant, (g.E * b - g.F * a) / determinant};
    };
    // A step that is so long that it ends in infinity is taken for a good one.
    for (double step = first_step; step > last_step; step /= 10) {
      Geodesic_state state = start;
      odeint::integrate_adaptive(
          odeint::make_controlled(tolerance, tolerance,
                                  odeint::runge_kutta_fehlberg78<Geodesic_state>()),
          derivative, state, 0., length, step * length);
      if (std::all_of(state.begin(), state.end(), [](double x) { return std::isfinite(x); }))
        return state;
    }
    throw Error("a geodesic cannot be followed: the metric is not positive on its way, or changes "
                "too fast; choose another chart");
  }

  Geodesic_state shoot(double angle, double length) const { return advance(begin(angle), length); }

private:
  Metric m_metric;
  double m_u, m_v;
  std::array<double, 2> m_first, m_second; // orthonormal
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_GEODESICS_GEODESICS_2_H
