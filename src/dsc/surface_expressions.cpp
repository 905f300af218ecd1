// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "surface_expressions.h"

#include "errors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace dsc {

Surface_expressions::Surface_expressions(const std::string& expressions, const std::string& place)
    : m_expression(expressions, {"u", "v", "x", "y", "z"}, place,
                   "torus, ellipsoid, three expressions in u and v, or three in x, y and z") {
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

bool Surface_expressions::repeats_after(const std::array<double, 2>& periods) const {
  static constexpr int samples = 5;
  static constexpr double short_step = 1e-3, // in periods
      tolerance = 1e-3;                      // relative, for periods with few digits
  const auto length = [&](double u, double v, double du, double dv) {
    const std::array<double, 3> p = (*this)(u, v), q = (*this)(u + du, v + dv);
    return std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
  };
  for (int i = 0; i < samples; ++i) {
    // The samples are neither on a line of symmetry nor on a common line.
    const double u = periods[0] * (.1 + .17 * i), v = periods[1] * (.83 - .13 * i * i / samples);
    for (const auto& [a, b] : {std::pair(1, 0), std::pair(0, 1), std::pair(1, 1)}) {
      const double du = a * short_step * periods[0], dv = b * short_step * periods[1],
                   here = length(u, v, du, dv);
      for (double there : {length(u + periods[0], v, du, dv), length(u, v + periods[1], du, dv)})
        if (!(std::abs(there - here) <= tolerance * std::max(here, there)))
          return false;
    }
  }
  return true;
}

std::array<double, 3> Surface_expressions::at(const std::array<double, 5>& variables) const {
  const auto& [u, v, x, y, z] = variables;
  const double* values = m_expression.at({u, v, x, y, z});
  return {values[0], values[1], values[2]};
}

} // namespace dsc
