// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_GEODESICS_GEODESICS_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_GEODESICS_GEODESICS_2_H

#include <CGAL/Deformable_simplicial_complex_2/Riemannian_metric_2.h>
#include <CGAL/Deformable_simplicial_complex_2/Sphere_like_surface_2.h>
#include <CGAL/Deformable_simplicial_complexes/Torus_domain.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/numeric/odeint.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// A point of a chart and the velocity of the geodesic there: u, v, u', v'.
using Geodesic_state = std::array<double, 4>;

// Where a geodesic is after another length. Throws Error where the metric is not positive.
template <class Metric>
Geodesic_state advance_geodesic(const Metric& metric, const Geodesic_state& start, double length) {
  namespace odeint = boost::numeric::odeint;
  static constexpr double tolerance = 1e-11, first_step = .2, last_step = 1e-5; // of the length
  if (length == 0)
    return start;
  const auto derivative = [&metric](const Geodesic_state& x, Geodesic_state& dx, double) {
    const Metric_jet_2 g = metric(x[0], x[1]);
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

// The geodesics from a point of a chart, of unit speed.
template <class Metric> class Geodesics_2
{
public:
  using Point = Simple_cartesian<double>::Point_2;
  using Domain = Torus_domain<2>;

  // By its angle from the direction along u, in radians.
  struct Departure
  {
    double angle, length;
  };

  Geodesics_2(const Metric& metric, const Domain& domain, const Point& source)
      : m_metric(metric), m_domain(domain), m_source(source), m_g(metric(source.x(), source.y())) {
    const double determinant = m_g.E * m_g.G - m_g.F * m_g.F;
    if (!(m_g.E > 0 && determinant > 0) || !std::isfinite(determinant))
      throw Error("the metric is not positive at the point: choose another one, or a chart that is "
                  "regular there");
    m_first = {1 / std::sqrt(m_g.E), 0};
    const double second = std::sqrt(m_g.E / determinant);
    m_second = {-m_g.F / m_g.E * second, second};
  }

  // Where a geodesic is, by its angle and length.
  Geodesic_state shoot(double angle, double length) const {
    const double c = std::cos(angle), s = std::sin(angle);
    return advance({m_source.x(), m_source.y(), c * m_first[0] + s * m_second[0],
                    c * m_first[1] + s * m_second[1]},
                   length);
  }

  Geodesic_state advance(const Geodesic_state& start, double length) const {
    return advance_geodesic(m_metric, start, length);
  }

  // To a point of the chart, if the metric were the same everywhere.
  Departure departure(const Point& p) const {
    const auto w = m_domain.near(m_source, p) - m_source;
    const double along = m_g.E * w.x() + m_g.F * w.y(), across = m_g.F * w.x() + m_g.G * w.y();
    return {std::atan2(std::sqrt(m_g.E * m_g.G - m_g.F * m_g.F) * w.y(), along),
            std::sqrt(along * w.x() + across * w.y())};
  }

  // About how far it is to the end of a small vector at the source.
  double length(double small) const { return small * std::sqrt((std::max)(m_g.E, m_g.G)); }

  // The radius of the first front, some edges away.
  double first_radius(double spacing) const {
    static constexpr double edges = 3;
    return length(edges * spacing);
  }

  bool is_in_chart(const Geodesic_state&) const { return true; }

private:
  Metric m_metric;
  Domain m_domain;
  Point m_source;
  Metric_jet_2 m_g;                        // at the source
  std::array<double, 2> m_first, m_second; // orthonormal
};

// They begin in a chart of their own, at whose origin the source is; in the chart of the surface it
// is infinitely far away.
template <class Embedding, template <class> class Differentiated>
class Geodesics_2<Sphere_like_surface_2<Embedding, Differentiated>>
{
public:
  using Surface = Sphere_like_surface_2<Embedding, Differentiated>;
  using Point = Simple_cartesian<double>::Point_2;
  using Domain = typename Surface::Domain;
  using At_source = Geodesics_2<typename Surface::Metric>;
  using Departure = typename At_source::Departure;

  explicit Geodesics_2(const Surface& surface)
      : m_surface(surface), m_at_source(surface.metric_at_source(), surface.domain(), Point(0, 0)) {
  }

  // The length is not 0.
  Geodesic_state shoot(double angle, double length) const {
    const double begin = (std::min)(length, first_radius());
    const Geodesic_state x = m_at_source.shoot(angle, begin);
    // By inversion in the unit circle, and then to the middle of the chart.
    const double squared = x[0] * x[0] + x[1] * x[1], turn = 2 * (x[0] * x[2] + x[1] * x[3]);
    Geodesic_state y;
    for (std::size_t i = 0; i < 2; ++i) {
      y[i] = Surface::half_width + x[i] / squared;
      y[i + 2] = (x[i + 2] - turn / squared * x[i]) / squared;
    }
    return advance(y, length - begin);
  }

  Geodesic_state advance(const Geodesic_state& start, double length) const {
    return advance_geodesic(m_surface, start, length);
  }

  Departure departure(const Point& p) const {
    const double x = p.x() - Surface::half_width, y = p.y() - Surface::half_width,
                 squared = x * x + y * y;
    return m_at_source.departure(Point(x / squared, y / squared));
  }

  // Its front is well within the box.
  double first_radius(double = 0) const {
    static constexpr double margin = .85;
    return m_at_source.length(1 / (margin * Surface::half_width));
  }

  bool is_in_chart(const Geodesic_state& state) const {
    const auto is_inside = [](double x) { return 0 < x && x < 2 * Surface::half_width; };
    return is_inside(state[0]) && is_inside(state[1]);
  }

private:
  Surface m_surface;
  At_source m_at_source;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_GEODESICS_GEODESICS_2_H
