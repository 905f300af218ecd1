// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_CUT_LOCI_2_INTERNAL_GEODESICS_GEODESIC_EQUATIONS_2_H
#define CGAL_CUT_LOCI_2_INTERNAL_GEODESICS_GEODESIC_EQUATIONS_2_H

#include <CGAL/Cut_loci_2/internal/geodesics/Geodesics_2.h>

#include <Eigen/Dense>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <optional>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A geodesic from the source, by its angle in radians and its length.
struct Geodesic_2
{
  double angle, length;
};

// Equations of geodesics from the source, which Newton's method solves. They give the geodesic to a
// point, the meeting of two or three geodesics of equal length, and the nearest conjugate point.
template <class Metric> class Geodesic_equations_2
{
public:
  using Geodesics = Geodesics_2<Metric>;
  using Domain = Torus_domain<2>;
  using Point = Epick::Point_2;
  using State = Geodesic_state;
  using Pair = Eigen::Vector2d;

  // A point where geodesics of equal length meet: their angles and their length.
  struct Meeting
  {
    std::vector<double> angles;
    double length;
    Point point;
  };

  // \param spacing the unit of lengths in the chart
  // \param step the unit of lengths of geodesics
  Geodesic_equations_2(const Geodesics& geodesics, const Domain& domain, double spacing,
                       double step)
      : m_geodesics(geodesics), m_domain(domain), m_spacing(spacing), m_step(step),
        m_orientation(area(0, before_conjugate * step) > 0 ? 1 : -1) {}

  const Geodesics& geodesics() const { return m_geodesics; }
  const Domain& domain() const { return m_domain; }
  double spacing() const { return m_spacing; }
  double step() const { return m_step; }

  static Point point(const State& s) { return Point(s[0], s[1]); }

  // Returns the geodesic to a point, from the geodesic `start` near it.
  std::optional<Geodesic_2> geodesic_to(const Point& p, const Geodesic_2& start) const {
    Geodesic_2 g = start;
    for (int i = 0; i < iterations; ++i) {
      const Arrival a = arrival(g);
      const Pair miss = difference(p, a.state);
      Eigen::Matrix2d jacobian;
      jacobian << a.by_angle, a.by_length;
      const Pair by = solve<2>(jacobian, miss);
      g.angle -= by[0];
      g.length -= m_step * by[1];
      if (is_far(start, g))
        return std::nullopt;
      if (miss.norm() < precision && by.norm() < precision)
        return m_geodesics.is_in_chart(a.state) ? std::optional(g) : std::nullopt;
    }
    return std::nullopt;
  }

  // Returns the point where geodesics of equal length meet. There are two geodesics, and the first
  // angle is fixed, or three geodesics. The arguments are initial guesses.
  std::optional<Meeting> meeting(const std::vector<double>& angles, double length) const {
    return angles.size() == 2 ? meeting_of<2>(angles, length) : meeting_of<3>(angles, length);
  }

  // Returns the direction between two others whose conjugate point is nearest, and the length of
  // its geodesic. `near` is an approximate length.
  std::optional<Geodesic_2> nearest_conjugate(double right, double left, double nearby) const {
    static constexpr int bits = 26; // half of the bits of a `double`: enough for a minimum
    std::uintmax_t calls = most_calls;
    const double nowhere = nearby + 2 * widest * m_step;
    const auto found = boost::math::tools::brent_find_minima(
        [&](double angle) { return conjugate_length(angle, nearby).value_or(nowhere); }, right,
        left, bits, calls);
    if (!(found.second < nowhere))
      return std::nullopt;
    return Geodesic_2{found.first, found.second};
  }

private:
  static constexpr int iterations = 30;
  static constexpr double before_conjugate = .1; // steps; no conjugate point is so near
  static constexpr std::uintmax_t most_calls = 100;
  static constexpr double widest = 8;       // steps around a length to search in
  static constexpr double precision = 1e-8; // in spacings, steps and radians

  // Returns the first length near a given length at which a geodesic is conjugate to the source.
  std::optional<double> conjugate_length(double angle, double nearby) const {
    double low = nearby, high = nearby;
    const auto diverges = [&](double length) { return spread(angle, length) > 0; };
    while (diverges(high) && high < nearby + widest * m_step)
      high += m_step / 2;
    while (!diverges(low) && low > m_step && low > nearby - widest * m_step)
      low -= m_step / 2;
    if (low == high || !diverges(low) || diverges(high))
      return std::nullopt;
    std::uintmax_t calls = most_calls;
    const auto found = boost::math::tools::toms748_solve(
        [&](double length) { return spread(angle, length); }, low, high,
        [this](double a, double b) { return b - a < precision * m_step; }, calls);
    return (found.first + found.second) / 2;
  }

  // The end of a geodesic and its derivatives, in spacings per radian and per step.
  struct Arrival
  {
    State state;
    Pair by_angle, by_length;
  };

  Arrival arrival(const Geodesic_2& g) const {
    static constexpr double widest_angle = 1e-5, narrowest_angle = 1e-9; // in radians
    static constexpr double farthest = 3e-3; // in spacings; the end is nearly linear within it
    const State state = m_geodesics.shoot(g.angle, g.length);
    const Point p = point(state);
    const auto left = [&](double width) {
      return difference(p, m_geodesics.shoot(g.angle + width, g.length));
    };
    double width = widest_angle;
    Pair by = left(width);
    while (by.norm() > farthest && width > narrowest_angle)
      by = left(width /= 10);
    return {state, by / width, Pair(state[2], state[3]) * (m_step / m_spacing)};
  }

  // Returns the vector from a point to a state, in spacings.
  Pair difference(const Point& p, const State& state) const {
    const Point q = m_domain.nearest_image(p, point(state));
    return Pair(q.x() - p.x(), q.y() - p.y()) / m_spacing;
  }

  // Returns the rate of divergence of neighboring geodesics at a length. It is negative beyond the
  // conjugate point.
  double spread(double angle, double length) const { return m_orientation * area(angle, length); }

  double area(double angle, double length) const {
    const Arrival a = arrival({angle, length});
    return a.by_length[0] * a.by_angle[1] - a.by_length[1] * a.by_angle[0];
  }

  // Returns a Newton step of bounded length. At a conjugate point, the matrix is singular. The
  // unknowns that the equations do not determine then stay nearly unchanged.
  template <int n>
  static Eigen::Matrix<double, n, 1> solve(const Eigen::Matrix<double, n, n>& matrix,
                                           const Eigen::Matrix<double, n, 1>& right) {
    static constexpr double longest = .5;     // in radians or steps
    static constexpr double singular = 1e-12; // of the largest pivot
    Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix<double, n, n>> decomposition(n, n);
    decomposition.setThreshold(singular);
    const Eigen::Matrix<double, n, 1> x = decomposition.compute(matrix).solve(right);
    const double length = x.norm();
    return length > longest ? Eigen::Matrix<double, n, 1>(x * (longest / length)) : x;
  }

  bool is_far(const Geodesic_2& from, const Geodesic_2& to) const {
    static constexpr double angle = 1, steps = 8;
    return !(std::abs(to.angle - from.angle) < angle && to.length > 0 &&
             std::abs(to.length - from.length) < steps * m_step);
  }

  // Returns the meeting of n geodesics. The unknowns are the length and the angles, except the
  // first angle if n is 2. Equal geodesics meet at every length. To exclude this solution, the
  // distance between two ends is divided by the chord of the angle between them.
  template <int n>
  std::optional<Meeting> meeting_of(const std::vector<double>& start, double length) const {
    static constexpr int unknowns = 2 * (n - 1), first = n == 2 ? 1 : 0;
    std::vector<double> angles = start;
    double r = length;
    for (int i = 0; i < iterations; ++i) {
      std::array<Arrival, n> a;
      for (int k = 0; k < n; ++k)
        a[k] = arrival({angles[k], r});
      const Point p = point(a[0].state);
      Eigen::Matrix<double, unknowns, unknowns> matrix;
      Eigen::Matrix<double, unknowns, 1> miss;
      matrix.setZero();
      double farthest = 0;
      for (int k = 1; k < n; ++k) {
        const int row = 2 * (k - 1);
        const double half = turn(angles[0], angles[k]) / 2, chord = 2 * std::abs(std::sin(half));
        farthest = (std::max)(farthest, difference(p, a[k].state).norm());
        const Pair distance = difference(p, a[k].state) / chord,
                   by_chord = distance / chord * std::copysign(std::cos(half), half);
        miss.template segment<2>(row) = distance;
        matrix.template block<2, 1>(row, 0) = (a[k].by_length - a[0].by_length) / chord;
        matrix.template block<2, 1>(row, 1 + k - first) = a[k].by_angle / chord - by_chord;
        if (first == 0)
          matrix.template block<2, 1>(row, 1) = by_chord - a[0].by_angle / chord;
      }
      const auto by = solve<unknowns>(matrix, miss);
      if (farthest < precision && m_step * std::abs(by[0]) < precision * r) {
        if (!m_geodesics.is_in_chart(a[0].state))
          return std::nullopt;
        return Meeting{angles, r, m_domain.canonical(p)};
      }
      r -= m_step * by[0];
      for (int k = first; k < n; ++k)
        angles[k] -= by[1 + k - first];
      for (int k = 0; k < n; ++k)
        if (is_far({start[k], length}, {angles[k], r}))
          return std::nullopt;
    }
    return std::nullopt;
  }

  const Geodesics& m_geodesics;
  Domain m_domain;
  double m_spacing, m_step;
  double m_orientation; // 1 or -1: orientation of the chart, as seen from the source
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_CUT_LOCI_2_INTERNAL_GEODESICS_GEODESIC_EQUATIONS_2_H
