// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "surface_expressions.h"

namespace dsc {

Surface_expressions::Surface_expressions(const std::string& expressions)
    : m_expression(expressions, {"u", "v", "x", "y", "z"}, "--surface",
                   "torus, ellipsoid, three expressions in u and v, or three in x, y and z") {
  if (m_expression.size() != 3)
    m_expression.refuse("has " + std::to_string(m_expression.size()) + " coordinates");
  const bool is_of_chart = m_expression.depends_on("u") || m_expression.depends_on("v");
  m_is_of_sphere =
      m_expression.depends_on("x") || m_expression.depends_on("y") || m_expression.depends_on("z");
  if (is_of_chart && m_is_of_sphere)
    m_expression.refuse("has variables of both kinds");
  if (!is_of_chart && !m_is_of_sphere)
    m_expression.refuse("is a point");
}

std::array<double, 3> Surface_expressions::at(const std::array<double, 5>& variables) const {
  const auto& [u, v, x, y, z] = variables;
  const double* values = m_expression.at({u, v, x, y, z});
  return {values[0], values[1], values[2]};
}

} // namespace dsc
