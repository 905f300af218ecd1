// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_INEQUALITIES_H
#define DSC_INEQUALITIES_H

#include "input/expression.h"

#include <array>
#include <string>
#include <vector>

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

} // namespace dsc

#endif // DSC_INEQUALITIES_H
