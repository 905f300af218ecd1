// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "surface_expressions.h"

#include "errors.h"

#include <CGAL/number_utils.h>

#include <muParser.h>

#include <cstddef>

namespace dsc {

struct Surface_expressions::Parser
{
  std::array<double, 5> variables = {};
  mu::Parser parser;
};

Surface_expressions::Surface_expressions(const std::string& expressions)
    : m_parser(std::make_shared<Parser>()) {
  static const std::array<const char*, 5> names = {"u", "v", "x", "y", "z"};
  static const std::string form =
      "; write torus, ellipsoid, three expressions in u and v, or three in x, y and z";
  int number = 0;
  bool is_of_chart = false;
  try {
    mu::Parser& parser = m_parser->parser;
    for (std::size_t i = 0; i < names.size(); ++i)
      parser.DefineVar(names[i], &m_parser->variables[i]);
    parser.DefineConst("pi", CGAL_PI);
    parser.SetExpr(expressions);
    parser.Eval(number);
    for (const auto& [name, place] : parser.GetUsedVar())
      (name == "u" || name == "v" ? is_of_chart : m_is_of_sphere) = true;
  } catch (const mu::Parser::exception_type& error) {
    throw Usage_error("--surface '" + expressions + "' cannot be read: " + error.GetMsg() + form);
  }
  if (number != 3)
    throw Usage_error("--surface '" + expressions + "' has " + std::to_string(number) +
                      " coordinates" + form);
  if (is_of_chart == m_is_of_sphere)
    throw Usage_error("--surface '" + expressions +
                      (is_of_chart ? "' has variables of both kinds" : "' is a point") + form);
}

std::array<double, 3> Surface_expressions::at(const std::array<double, 5>& variables) const {
  m_parser->variables = variables;
  int number;
  const double* values = m_parser->parser.Eval(number);
  return {values[0], values[1], values[2]};
}

} // namespace dsc
