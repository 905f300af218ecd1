// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_CUT_LOCI_2_INTERNAL_GEODESICS_GEODESICS_2_H
#define CGAL_CUT_LOCI_2_INTERNAL_GEODESICS_GEODESICS_2_H

#include <CGAL/Cut_loci_2/Riemannian_metric_2.h>
#include <CGAL/Cut_loci_2/Sphere_like_surface_2.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <boost/numeric/odeint.hpp>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Directions at a point are angles in radians. Angles increase to the left.

inline double full_turn() { return 2 * std::acos(-1.); }

// Returns the angle from a direction to another one, positive to the left, in [-pi, pi].
inline double turn(double from, double to) { return std::remainder(to - from, full_turn()); }

// Returns the angle in (0, 2 pi] from the direction `right` to the left, up to the direction
// `left`.
inline double gap_between(double right, double left) {
  const double gap = std::fmod(left - right, full_turn());
  return gap > 0 ? gap : gap + full_turn();
}

// Returns a direction as an angle in [0, 2 pi).
inline double canonical_angle(double angle) {
  const double a = std::fmod(angle, full_turn());
  return a < 0 ? a + full_turn() : a;
}

// A point of a chart and the velocity of a geodesic there: u, v, u', v'.
using Geodesic_state = std::array<double, 4>;

// The units of length in the chart and on the manifold, of the size of the whole problem. With
// them, tolerances do not depend on the scale.
struct Geodesic_units
{
  double chart, manifold;
};

// Returns the state of a geodesic after a further length. Throws Error where the metric is not
// positive definite.
template <class Metric>
Geodesic_state advance_geodesic(const Metric& metric, const Geodesic_units& units,
                                const Geodesic_state& start, double length) {
  namespace odeint = boost::numeric::odeint;
  static constexpr double tolerance = 1e-11, first_step = .2, shortest = 1e-12; // of length
  static constexpr double short_step = .02; // in units; usually needs one step
  static constexpr int most_steps = 100000;
  if (length == 0)
    return start;
  const auto derivative = [&](const Geodesic_state& x, Geodesic_state& dx, double) {
    const Metric_jet_2 g = metric(units.chart * x[0], units.chart * x[1]);
    const double p = x[2], q = x[3];
    const double a = -(g.E_u / 2 * p * p + g.E_v * p * q + (g.F_v - g.G_u / 2) * q * q),
                 b = -((g.F_u - g.E_v / 2) * p * p + g.G_u * p * q + g.G_v / 2 * q * q),
                 determinant = g.E * g.G - g.F * g.F;
    if (!(g.E > 0 && determinant > 0))
      throw Error("a geodesic cannot be integrated: the metric is not positive definite along it; "
                  "choose another chart");
    const double scale = units.chart / determinant;
    dx = {p, q, scale * (g.G * a - g.F * b), scale * (g.E * b - g.F * a)};
  };
  const double speed = units.manifold / units.chart, whole = length / units.manifold;
  Geodesic_state state = {start[0] / units.chart, start[1] / units.chart, speed * start[2],
                          speed * start[3]};
  auto stepper = odeint::make_controlled(tolerance, tolerance,
                                         odeint::runge_kutta_fehlberg78<Geodesic_state>());
  double done = 0, step = std::abs(whole) < short_step ? whole : first_step * whole;
  for (int i = 0; i < most_steps && std::abs(whole - done) > shortest * std::abs(whole); ++i) {
    Progress_scope::check();
    if (std::abs(step) > std::abs(whole - done))
      step = whole - done;
    // The stepper accepts steps whose result is not finite. They are repeated with a tenth of the
    // length.
    const Geodesic_state before = state;
    const double done_before = done, tried = step;
    stepper.try_step(derivative, state, done, step);
    if (!std::all_of(state.begin(), state.end(), [](double x) { return std::isfinite(x); })) {
      state = before;
      done = done_before;
      step = tried / 10;
    }
    if (!(std::abs(step) > shortest * std::abs(whole)))
      break;
  }
  if (!(std::abs(whole - done) <= shortest * std::abs(whole)))
    throw Error(
        "a geodesic cannot be integrated: the metric changes too fast; choose another chart");
  return {units.chart * state[0], units.chart * state[1], state[2] / speed, state[3] / speed};
}

// The geodesics of unit speed from a point of a chart.
template <class Metric> class Geodesics_2
{
public:
  using Point = Epick::Point_2;
  using Domain = Torus_domain<2>;

  // A geodesic from the source: its angle from the direction along u, in radians, and its length.
  struct Departure
  {
    double angle, length;
  };

  Geodesics_2(const Metric& metric, const Domain& domain, const Point& source)
      : m_metric(metric), m_domain(domain), m_source(source), m_g(metric(source.x(), source.y())) {
    const double determinant = m_g.E * m_g.G - m_g.F * m_g.F;
    if (!std::isfinite(source.x()) || !std::isfinite(source.y()))
      throw Error("the source point is not finite: correct its coordinates");
    if (!(m_g.E > 0 && determinant > 0) || !std::isfinite(determinant))
      throw Error("the metric is not positive definite at the source point: choose another point, "
                  "or a chart that is regular there");
    const double half_trace = (m_g.E + m_g.G) / 2,
                 root = std::sqrt((std::max)(0., half_trace * half_trace - determinant));
    m_longest = std::sqrt(half_trace + root);
    m_shortest = std::sqrt(determinant) / m_longest;
    m_extent = {std::sqrt(m_g.G / determinant), std::sqrt(m_g.E / determinant)};
    m_units.chart = (std::max)(domain.periods()[0], domain.periods()[1]);
    m_units.manifold = m_longest * m_units.chart;
    m_first = {1 / std::sqrt(m_g.E), 0};
    const double second = std::sqrt(m_g.E / determinant);
    m_second = {-m_g.F / m_g.E * second, second};
  }

  // Returns the state of the geodesic with the given angle and length.
  Geodesic_state shoot(double angle, double length) const {
    const double c = std::cos(angle), s = std::sin(angle);
    return advance({m_source.x(), m_source.y(), c * m_first[0] + s * m_second[0],
                    c * m_first[1] + s * m_second[1]},
                   length);
  }

  Geodesic_state advance(const Geodesic_state& start, double length) const {
    return advance_geodesic(m_metric, m_units, start, length);
  }

  // Returns the geodesic to a point of the chart, for the constant metric of the source.
  Departure departure(const Point& p) const {
    const auto w = m_domain.nearest_image(m_source, p) - m_source;
    const double along = m_g.E * w.x() + m_g.F * w.y(), across = m_g.F * w.x() + m_g.G * w.y();
    return {std::atan2(std::sqrt(m_g.E * m_g.G - m_g.F * m_g.F) * w.y(), along),
            std::sqrt(along * w.x() + across * w.y())};
  }

  // Returns the length of a vector of the chart at a point.
  double length(const Point& p, double du, double dv) const {
    const Metric_jet_2 g = m_metric(p.x(), p.y());
    return std::sqrt(g.E * du * du + 2 * g.F * du * dv + g.G * dv * dv);
  }

  // Returns the least or the largest length on the manifold of vectors with a given length in the
  // chart, at the source.
  double shortest(double in_chart) const { return m_shortest * in_chart; }
  double longest(double in_chart) const { return m_longest * in_chart; }

  // Returns the length at which geodesics lie in the chart: a step.
  double shortest_length(double step) const { return step; }

  // Returns the radius of the initial front, which is some edges long. Throws Error if the front
  // would go around the torus.
  double first_radius(double spacing) const {
    static constexpr double edges = 3, widest = .45; // number of edges; part of a period
    const double radius = longest(edges * spacing);
    for (std::size_t axis = 0; axis < 2; ++axis)
      if (!(m_extent[axis] * radius < widest * m_domain.periods()[axis]))
        throw Error("the initial front goes around the torus, since the metric is too anisotropic: "
                    "use a smaller spacing");
    return radius;
  }

  // The number of independent cycles of the cut locus. Its complement is a disk.
  static constexpr std::size_t cycles_of_cut_locus = 2;
  bool is_in_chart(const Geodesic_state&) const { return true; }

private:
  Metric m_metric;
  Domain m_domain;
  Point m_source;
  Metric_jet_2 m_g;                        // at the source
  std::array<double, 2> m_first, m_second; // orthonormal
  double m_longest, m_shortest;            // of unit vectors of the chart
  std::array<double, 2> m_extent;          // of the unit disk along the axes of the chart
  Geodesic_units m_units;
};

// The geodesics of a sphere-like surface. They begin in a chart with the source at its origin. In
// the chart of the surface, the source is infinitely far away.
template <class Embedding, template <class> class Differentiated>
class Geodesics_2<Sphere_like_surface_2<Embedding, Differentiated>>
{
public:
  using Surface = Sphere_like_surface_2<Embedding, Differentiated>;
  using Point = Epick::Point_2;
  using Domain = typename Surface::Domain;
  using At_source = Geodesics_2<typename Surface::Metric>;
  using Departure = typename At_source::Departure;

  explicit Geodesics_2(const Surface& surface)
      : m_surface(surface), m_at_source(surface.metric_at_source(), surface.domain(), Point(0, 0)),
        m_opposite(Opposite(surface), surface.domain(),
                   Point(Surface::half_width, Surface::half_width)),
        m_units{Surface::half_width, m_opposite.longest(Surface::half_width)} {}

  // Returns the state of the geodesic with the given angle and length. The length is not 0.
  Geodesic_state shoot(double angle, double length) const {
    const double begin = (std::min)(length, first_radius());
    const Geodesic_state x = m_at_source.shoot(angle, begin);
    // An inversion in the unit circle and a translation change the chart.
    const double squared = x[0] * x[0] + x[1] * x[1], turn = 2 * (x[0] * x[2] + x[1] * x[3]);
    Geodesic_state y;
    for (std::size_t i = 0; i < 2; ++i) {
      y[i] = Surface::half_width + x[i] / squared;
      y[i + 2] = (x[i + 2] - turn / squared * x[i]) / squared;
    }
    return advance(y, length - begin);
  }

  Geodesic_state advance(const Geodesic_state& start, double length) const {
    return advance_geodesic(m_surface, m_units, start, length);
  }

  Departure departure(const Point& p) const {
    const double x = p.x() - Surface::half_width, y = p.y() - Surface::half_width,
                 squared = x * x + y * y;
    return m_at_source.departure(Point(x / squared, y / squared));
  }

  double length(const Point& p, double du, double dv) const { return m_opposite.length(p, du, dv); }

  // Measured opposite to the source, where the front closes.
  double shortest(double in_chart) const { return m_opposite.shortest(in_chart); }
  double longest(double in_chart) const { return m_opposite.longest(in_chart); }

  // Returns the length at which geodesics lie in the chart. They enter it from infinity.
  double shortest_length(double) const { return first_radius(); }

  // Returns the radius of the initial front, which lies inside the box.
  double first_radius(double = 0) const {
    static constexpr double margin = .85;
    return m_at_source.longest(1 / (margin * Surface::half_width));
  }

  static constexpr std::size_t cycles_of_cut_locus = 0;

  bool is_in_chart(const Geodesic_state& state) const {
    const auto is_inside = [](double x) { return 0 < x && x < 2 * Surface::half_width; };
    return is_inside(state[0]) && is_inside(state[1]);
  }

private:
  // The metric as a type without a source, so that the general template is used.
  struct Opposite : Surface
  {
    explicit Opposite(const Surface& surface) : Surface(surface) {}
  };

  Surface m_surface;
  At_source m_at_source;
  Geodesics_2<Opposite> m_opposite;
  Geodesic_units m_units;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_CUT_LOCI_2_INTERNAL_GEODESICS_GEODESICS_2_H
