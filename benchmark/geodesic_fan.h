// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_BENCHMARK_GEODESIC_FAN_H
#define DSC_BENCHMARK_GEODESIC_FAN_H

#include <CGAL/number_utils.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <vector>

/// Distances on implicit surfaces by brute force. The code is independent of the library: geodesics
/// are integrated in space, without charts.
namespace dsc_benchmark::geodesic_fan {

using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;

/// A number with its first and second derivatives with respect to the coordinates in space.
struct Number
{
  double value;
  Vector gradient;
  Matrix hessian;

  Number(double x) : value(x), gradient(Vector::Zero()), hessian(Matrix::Zero()) {}
  Number(double x, const Vector& g, const Matrix& h) : value(x), gradient(g), hessian(h) {}

  /// Returns f(a) from f and its derivatives at the value of a.
  friend Number chain(const Number& a, double f, double first, double second) {
    return {f, first * a.gradient,
            first * a.hessian + second * a.gradient * a.gradient.transpose()};
  }

  friend Number operator+(const Number& a, const Number& b) {
    return {a.value + b.value, a.gradient + b.gradient, a.hessian + b.hessian};
  }
  friend Number operator-(const Number& a, const Number& b) {
    return {a.value - b.value, a.gradient - b.gradient, a.hessian - b.hessian};
  }
  friend Number operator*(const Number& a, const Number& b) {
    const Matrix mixed = a.gradient * b.gradient.transpose();
    return {a.value * b.value, a.value * b.gradient + b.value * a.gradient,
            a.value * b.hessian + b.value * a.hessian + mixed + mixed.transpose()};
  }
  friend Number operator/(const Number& a, const Number& b) {
    const double x = b.value;
    return a * chain(b, 1 / x, -1 / (x * x), 2 / (x * x * x));
  }
  friend Number sqrt(const Number& a) {
    const double root = std::sqrt(a.value);
    return chain(a, root, 1 / (2 * root), -1 / (4 * root * a.value));
  }
  friend Number cos(const Number& a) {
    return chain(a, std::cos(a.value), -std::sin(a.value), -std::cos(a.value));
  }
};

/// The state of a geodesic: position, direction, distance of neighbors per angle, and its
/// derivative.
using State = Eigen::Matrix<double, 8, 1>;

/// The fan of geodesics from a point of the surface f = 0.
///
/// \tparam Implicit has `template <class T> T operator()(const T& x, const T& y, const T& z) const`
///         and `std::array<double, 3> periods() const`, 0 for coordinates without
template <class Implicit> class Fan
{
public:
  Fan(const Implicit& implicit, const Vector& source)
      : m_implicit(implicit), m_source(source), m_periods(implicit.periods()) {
    const Vector normal = value(source).gradient.normalized();
    m_first = normal.unitOrthogonal();
    m_second = normal.cross(m_first);
  }

  /// Returns the distances of points of the surface from the source, or infinity if no geodesic up
  /// to a length comes near a point.
  std::vector<double> distances(const std::vector<Vector>& points, double farthest, int rays) {
    m_points = &points;
    m_distances.assign(points.size(), std::numeric_limits<double>::infinity());
    m_farthest = farthest;
    m_cells.clear();
    for (std::size_t i = 0; i < points.size(); ++i)
      for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
          for (int z = -1; z <= 1; ++z)
            m_cells[cell(points[i], {x, y, z})].push_back(i);
    for (int i = 0; i < rays; ++i)
      follow(2 * CGAL_PI * (i + .5) / rays, 2 * CGAL_PI / rays);
    return m_distances;
  }

  /// Returns the vector from a point to the nearest periodic image of another point.
  Vector difference(const Vector& from, const Vector& to) const {
    Vector d = to - from;
    for (int i = 0; i < 3; ++i)
      if (m_periods[i] > 0)
        d[i] = std::remainder(d[i], m_periods[i]);
    return d;
  }

  /// Returns f at a point.
  Number value(const Vector& p) const {
    const auto coordinate = [&](int i) { return Number(p[i], Vector::Unit(i), Matrix::Zero()); };
    return m_implicit(coordinate(0), coordinate(1), coordinate(2));
  }

private:
  static constexpr double longest_step = .02, widest = .01;            // per largest distance
  static constexpr double step_of_radius = .05, width_of_radius = .15; // per radius of curvature
  static constexpr double beyond = .75;   // per width of a strip; half of it is its own
  static constexpr double steepest = .25; // slope of the surface relative to its tangent plane
  static constexpr double margin = 1e-6;  // per largest distance: strips where geodesics meet

  // Returns the cell of space that contains a point, or a cell at an offset from it.
  std::array<int, 3> cell(const Vector& p, const std::array<int, 3>& shift) const {
    const double size = (std::max)(longest_step, widest) * m_farthest;
    std::array<int, 3> c;
    for (int i = 0; i < 3; ++i) {
      const int number = (std::max)(3, int(m_periods[i] / size)); // minimum: all shifts differ
      if (m_periods[i] > 0) {
        const int index = int(std::floor(p[i] / m_periods[i] * number)) + shift[i];
        c[i] = (index % number + number) % number;
      } else {
        c[i] = int(std::floor(p[i] / size)) + shift[i];
      }
    }
    return c;
  }

  // Follows the strip around a direction, and narrower strips if it is too wide.
  void follow(double angle, double width) {
    static constexpr int parts = 4;
    State s;
    s << m_source, std::cos(angle) * m_first + std::sin(angle) * m_second, 0, 1;
    for (double length = 0; length < m_farthest;) {
      const Number f = value(s.head<3>());
      const double curvature = f.hessian.norm() / f.gradient.norm();
      if (std::abs(s[6]) * width > (std::min)(widest * m_farthest, width_of_radius / curvature)) {
        for (int i = 0; i < parts; ++i)
          follow(angle + ((i + .5) / parts - .5) * width, width / parts);
        return;
      }
      const double step = (std::min)(longest_step * m_farthest, step_of_radius / curvature);
      visit(s, f.gradient.normalized(), length, step, width);
      s = advanced(s, step);
      length += step;
    }
  }

  // Updates the distances of points in a part of a strip, to second order in the distance from the
  // geodesic.
  void visit(const State& s, const Vector& normal, double length, double step, double width) {
    const Vector here = s.head<3>(), direction = s.segment<3>(3);
    const auto nearby = m_cells.find(cell(here, {0, 0, 0}));
    if (nearby == m_cells.end())
      return;
    const double half = beyond * std::abs(s[6]) * width;
    for (std::size_t i : nearby->second) {
      const Vector d = difference(here, (*m_points)[i]);
      const double ahead = d.dot(direction), side = d.dot(normal.cross(direction)),
                   above = d.dot(normal);
      if (std::abs(ahead) > step || std::abs(side) > half + margin * m_farthest ||
          std::abs(above) > steepest * (step + half)) // on another part of the surface
        continue;
      const double bend = std::abs(side) < half ? side * side * s[7] / (2 * s[6]) : 0;
      m_distances[i] = (std::min)(m_distances[i], length + ahead + bend);
    }
  }

  // x'' is normal to the surface; neighbors y satisfy y'' = -K y (Jacobi).
  State derivative(const State& s) const {
    const Vector v = s.segment<3>(3);
    const Number f = value(s.head<3>());
    const Matrix& h = f.hessian;
    const double squared = f.gradient.squaredNorm();
    Matrix adjugate;
    for (int i = 0; i < 3; ++i)
      adjugate.row(i) = h.row((i + 1) % 3).cross(h.row((i + 2) % 3));
    const double curvature = f.gradient.dot(adjugate * f.gradient) / (squared * squared);
    State d;
    d << v, -(v.dot(h * v) / squared) * f.gradient, s[7], -curvature * s[6];
    return d;
  }

  // The classical Runge-Kutta method.
  State advanced(const State& s, double step) const {
    const State a = derivative(s), b = derivative(s + step / 2 * a),
                c = derivative(s + step / 2 * b), d = derivative(s + step * c);
    return s + step / 6 * (a + 2 * b + 2 * c + d);
  }

  Implicit m_implicit;
  Vector m_source, m_first, m_second;
  std::array<double, 3> m_periods;
  const std::vector<Vector>* m_points = nullptr;
  std::vector<double> m_distances;
  double m_farthest = 0;
  std::map<std::array<int, 3>, std::vector<std::size_t>> m_cells;
};

} // namespace dsc_benchmark::geodesic_fan

#endif // DSC_BENCHMARK_GEODESIC_FAN_H
