// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_VELOCITY_EXPRESSIONS_H
#define DSC_VELOCITY_EXPRESSIONS_H

#include "input/expression.h"

#include <array>
#include <string>

namespace dsc {

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

} // namespace dsc

#endif // DSC_VELOCITY_EXPRESSIONS_H
