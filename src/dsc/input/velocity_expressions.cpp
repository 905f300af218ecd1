// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/velocity_expressions.h"

#include "programs/errors.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace dsc {
namespace {

std::string form(int dimension) {
  return dimension == 2 ? "two expressions in x, y and t like '-y,sin(pi*t)'"
                        : "three expressions in x, y, z and t like '-y,x,sin(pi*t)'";
}

} // namespace

Velocity_expressions::Velocity_expressions(const std::string& expressions, int dimension)
    : m_expression(expressions, coordinate_names(dimension, {"t"}), "--velocity", form(dimension)) {
  if (m_expression.size() != dimension)
    m_expression.refuse("has " + std::to_string(m_expression.size()) +
                        noun(std::size_t(m_expression.size()), " component", " components"));
}

std::array<double, 3> Velocity_expressions::at(const std::array<double, 3>& p, double t) const {
  const double* values = m_expression.at_point(p, m_expression.size(), t);
  std::array<double, 3> result = {};
  std::copy_n(values, m_expression.size(), result.begin());
  return result;
}

} // namespace dsc
