// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "velocity_expressions.h"

#include "errors.h"

#include <CGAL/number_utils.h>

#include <muParser.h>

#include <algorithm>

namespace dsc {

struct Velocity_expressions::Parser
{
  std::array<double, 4> variables = {};
  mu::Parser parser;
};

Velocity_expressions::Velocity_expressions(const std::string& expressions, int dimension)
    : m_parser(std::make_unique<Parser>()) {
  const std::string form = dimension == 2
                               ? "two expressions in x, y and t like '-y,sin(pi*t)'"
                               : "three expressions in x, y, z and t like '-y,x,sin(pi*t)'";
  static const std::array<const char*, 4> names = {"x", "y", "z", "t"};
  int number = 0;
  try {
    mu::Parser& parser = m_parser->parser;
    for (std::size_t i = 0; i < names.size(); ++i)
      parser.DefineVar(names[i], &m_parser->variables[i]);
    parser.DefineConst("pi", CGAL_PI);
    parser.SetExpr(expressions);
    parser.Eval(number);
  } catch (const mu::Parser::exception_type& error) {
    throw Usage_error("--velocity '" + expressions + "' cannot be read: " + error.GetMsg() +
                      "; write " + form);
  }
  if (number != dimension)
    throw Usage_error("--velocity '" + expressions + "' has " + std::to_string(number) +
                      " components; write " + form);
}

Velocity_expressions::~Velocity_expressions() = default;

std::array<double, 3> Velocity_expressions::at(const std::array<double, 3>& p, double t) const {
  m_parser->variables = {p[0], p[1], p[2], t};
  int number;
  const double* values = m_parser->parser.Eval(number);
  std::array<double, 3> result = {};
  std::copy_n(values, number, result.begin());
  return result;
}

} // namespace dsc
