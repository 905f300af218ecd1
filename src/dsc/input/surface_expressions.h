// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_SURFACE_EXPRESSIONS_H
#define DSC_SURFACE_EXPRESSIONS_H

#include "input/expression.h"

#include <array>
#include <cstddef>
#include <string>

namespace dsc {

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

} // namespace dsc

#endif // DSC_SURFACE_EXPRESSIONS_H
