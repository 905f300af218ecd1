// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FUNCTIONS_OF_POINTS_H
#define DSC_FUNCTIONS_OF_POINTS_H

#include "input/expression.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace dsc {

/// Regions, each defined by an inequality in x, y and z like 'x^2+y^2+z^2<1', or by several
/// inequalities with && and || between them. Copies share the parsers.
class Inequalities
{
public:
  /// \throws Usage_error if an inequality cannot be read, or is constant
  explicit Inequalities(const std::vector<std::string>& expressions);

  /// Returns the number, from 1, of the last inequality that holds at a point; 0 if none holds. A
  /// comparison with an undefined value, like sqrt(x) for negative x, does not hold.
  /// \throws Input_error if a value is not finite
  int label_at(const std::array<double, 3>& p) const;

private:
  std::vector<Expression> m_expressions;
};

/// A velocity field given by expressions that are separated by commas: three in x, y, z and t, or
/// two in x, y and t in the plane.
class Velocity_expressions
{
public:
  /// \throws Usage_error with the reason and the place if the number of expressions is not the
  /// dimension
  Velocity_expressions(const std::string& expressions, int dimension);

  /// Returns the velocity at a point. In the plane, z is 0 for the point and the velocity.
  /// \throws Input_error if the velocity is not finite
  std::array<double, 3> at(const std::array<double, 3>& p, double t) const;

private:
  Expression m_expression;
};

/// A surface given by three expressions, separated by commas, in the coordinates u and v of a
/// chart, or in the coordinates x, y and z of the unit sphere. Copies share the parser.
class Surface_expressions
{
public:
  /// \param place description of the expressions for messages
  /// \param names names of surfaces that are accepted instead, for messages
  /// \throws Usage_error with the reason and the place if these are not three expressions in one of
  /// the two sets of variables
  explicit Surface_expressions(const std::string& expressions,
                               const std::string& place = "--surface",
                               const std::string& names = "torus, ellipsoid, ");

  /// Returns whether the surface is the image of the unit sphere.
  bool is_of_sphere() const { return m_is_of_sphere; }

  std::array<double, 3> operator()(double u, double v) const { return at({u, v, 0, 0, 0}); }
  std::array<double, 3> operator()(const std::array<double, 2>& p) const {
    return (*this)(p[0], p[1]);
  }
  std::array<double, 3> operator()(const std::array<double, 3>& p) const {
    return at({0, 0, p[0], p[1], p[2]});
  }

  /// Returns the images of many points of the chart or of the sphere.
  template <class Coordinates, std::size_t n>
  std::array<std::array<double, 3>, n> images(const std::array<Coordinates, n>& points) const {
    std::array<std::array<double, 3>, n> result;
    for (std::size_t i = 0; i < n; ++i)
      result[i] = (*this)(points[i]);
    return result;
  }

private:
  std::array<double, 3> at(const std::array<double, 5>& variables) const;

  Expression m_expression;
  bool m_is_of_sphere = false;
};

/// Returns whether lengths on a surface in u and v are periodic, tested at samples.
/// \param image function of u and v that returns a point in space
template <class Image>
bool lengths_repeat(const Image& image, const std::array<double, 2>& periods) {
  static constexpr int samples = 5;
  static constexpr double short_step = 1e-3, // in periods
      tolerance = 1e-3;                      // relative, for periods with few digits
  const auto length = [&](double u, double v, double du, double dv) {
    const std::array<double, 3> p = image(u, v), q = image(u + du, v + dv);
    return std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
  };
  for (int i = 0; i < samples; ++i) {
    // The samples are neither on a line of symmetry nor on a common line.
    const double u = periods[0] * (.1 + .17 * i), v = periods[1] * (.83 - .13 * i * i / samples);
    for (const auto& [a, b] : {std::pair(1, 0), std::pair(0, 1), std::pair(1, 1)}) {
      const double du = a * short_step * periods[0], dv = b * short_step * periods[1],
                   here = length(u, v, du, dv);
      for (double there : {length(u + periods[0], v, du, dv), length(u, v + periods[1], du, dv)})
        if (!(std::abs(there - here) <= tolerance * (std::max)(here, there)))
          return false;
    }
  }
  return true;
}

} // namespace dsc

#endif // DSC_FUNCTIONS_OF_POINTS_H
