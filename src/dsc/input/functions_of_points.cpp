// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/functions_of_points.h"

#include "programs/errors.h"

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

Surface_expressions::Surface_expressions(const std::string& expressions, const std::string& place,
                                         const std::string& names)
    : m_expression(expressions, {"u", "v", "x", "y", "z"}, place,
                   names + "three expressions in u and v, or three in x, y and z") {
  if (m_expression.size() != 3)
    m_expression.refuse("has " + std::to_string(m_expression.size()) +
                        noun(std::size_t(m_expression.size()), " coordinate", " coordinates"));
  const bool is_of_chart = m_expression.depends_on("u") || m_expression.depends_on("v");
  m_is_of_sphere =
      m_expression.depends_on("x") || m_expression.depends_on("y") || m_expression.depends_on("z");
  if (is_of_chart && m_is_of_sphere)
    m_expression.refuse("contains u or v together with x, y or z");
  if (!is_of_chart && !m_is_of_sphere)
    m_expression.refuse("is constant");
}

std::array<double, 3> Surface_expressions::at(const std::array<double, 5>& variables) const {
  const auto& [u, v, x, y, z] = variables;
  const double* values = m_expression.at({u, v, x, y, z});
  return {values[0], values[1], values[2]};
}

} // namespace dsc
