// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/inequalities.h"

#include <cstddef>

namespace dsc {

Inequalities::Inequalities(const std::vector<std::string>& expressions) {
  for (const std::string& text : expressions) {
    const Expression& expression =
        m_expressions.emplace_back(text, std::vector<std::string>{"x", "y", "z"}, "the inequality",
                                   "an inequality in x, y and z like 'x^2+y^2+z^2<1'");
    if (expression.size() != 1)
      expression.refuse(
          "contains commas; give several inequalities as several INPUTs, or join them by && "
          "or ||");
    if (expression.is_constant())
      expression.refuse("is constant");
  }
}

int Inequalities::label_at(const std::array<double, 3>& p) const {
  for (std::size_t i = m_expressions.size(); i > 0; --i)
    if (*m_expressions[i - 1].at({p[0], p[1], p[2]}) != 0)
      return static_cast<int>(i);
  return 0;
}

} // namespace dsc
