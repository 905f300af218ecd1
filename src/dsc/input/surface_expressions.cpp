// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/surface_expressions.h"

#include "programs/errors.h"

#include <cstddef>

namespace dsc {

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
