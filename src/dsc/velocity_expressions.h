// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_VELOCITY_EXPRESSIONS_H
#define DSC_VELOCITY_EXPRESSIONS_H

#include "expression.h"

#include <array>
#include <string>

namespace dsc {

/// A velocity field: three expressions in x, y, z and t, in the plane two in x, y and t, with
/// commas between them.
class Velocity_expressions
{
public:
  /// \throws Usage_error if these are not as many expressions as there are dimensions, with what is
  /// wrong and where
  Velocity_expressions(const std::string& expressions, int dimension);

  /// At a point, whose z is 0 in the plane; so is then that of the velocity.
  /// \throws Input_error if the velocity is not finite
  std::array<double, 3> at(const std::array<double, 3>& p, double t) const;

private:
  Expression m_expression;
};

} // namespace dsc

#endif // DSC_VELOCITY_EXPRESSIONS_H
