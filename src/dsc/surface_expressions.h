// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_SURFACE_EXPRESSIONS_H
#define DSC_SURFACE_EXPRESSIONS_H

#include "expression.h"

#include <array>
#include <string>

namespace dsc {

/// A surface given by three expressions, with commas between them, in u and v, the coordinates
/// of a chart, or in x, y and z, those of the unit sphere. Copies share the parser.
class Surface_expressions
{
public:
  /// \throws Usage_error if these are not three expressions in one of the two sets of variables,
  /// with what is wrong and where
  explicit Surface_expressions(const std::string& expressions);

  /// Whether it is the image of the unit sphere.
  bool is_of_sphere() const { return m_is_of_sphere; }

  /// Whether lengths on a surface in u and v are the same a period further, where samples are
  /// taken.
  bool repeats_after(const std::array<double, 2>& periods) const;

  std::array<double, 3> operator()(double u, double v) const { return at({u, v, 0, 0, 0}); }
  std::array<double, 3> operator()(const std::array<double, 3>& p) const {
    return at({0, 0, p[0], p[1], p[2]});
  }

private:
  std::array<double, 3> at(const std::array<double, 5>& variables) const;

  Expression m_expression;
  bool m_is_of_sphere = false;
};

} // namespace dsc

#endif // DSC_SURFACE_EXPRESSIONS_H
