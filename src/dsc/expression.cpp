// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "expression.h"

#include "errors.h"
#include "expression_syntax.h"

#include <CGAL/number_utils.h>

#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>

namespace dsc {

struct Expression::Parser
{
  std::string text, place, form;
  std::vector<std::string> names;
  std::vector<double> variables; // read by muParser
  mu::Parser parser;

  [[noreturn]] void refuse_value(double value) const {
    std::ostringstream message;
    message.precision(10);
    message << place << " '" << text << "' is " << value;
    const auto used = parser.GetUsedVar();
    bool is_first = true;
    for (std::size_t i = 0; i < names.size(); ++i)
      if (used.count(names[i]) > 0) {
        message << (is_first ? " at " : ", ") << names[i] << " = " << variables[i];
        is_first = false;
      }
    message << "; the value must be finite, as in 'x>0?1/x:0'";
    throw Input_error(message.str());
  }
};

Expression::Expression(const std::string& text, const std::vector<std::string>& variables,
                       const std::string& place, const std::string& form)
    : m_parser(std::make_shared<Parser>()) {
  m_parser->text = text;
  m_parser->place = place;
  m_parser->form = form;
  m_parser->names = variables;
  m_parser->variables.resize(variables.size());
  try {
    mu::Parser& parser = m_parser->parser;
    for (std::size_t i = 0; i < variables.size(); ++i)
      parser.DefineVar(variables[i], &m_parser->variables[i]);
    parser.DefineConst("pi", CGAL_PI);
    std::vector<std::string> values = variables, functions;
    for (const auto& constant : parser.GetConst())
      values.push_back(constant.first);
    for (const auto& function : parser.GetFunDef())
      functions.push_back(function.first);
    parser.SetExpr(translate_expressions(text, values, functions));
    parser.Eval(m_size);
  } catch (const mu::Parser::exception_type& error) {
    refuse("cannot be parsed: " + error.GetMsg());
  } catch (const Syntax_error& error) {
    refuse(std::string("cannot be parsed: ") + error.what());
  }
}

void Expression::refuse(const std::string& why) const {
  throw Usage_error(m_parser->place + " '" + m_parser->text + "' " + why + "; write " +
                    m_parser->form);
}

bool Expression::depends_on(const std::string& variable) const {
  return m_parser->parser.GetUsedVar().count(variable) > 0;
}

bool Expression::is_constant() const { return m_parser->parser.GetUsedVar().empty(); }

const double* Expression::at(std::initializer_list<double> variables) const {
  std::copy(variables.begin(), variables.end(), m_parser->variables.begin());
  int number;
  const double* const values = m_parser->parser.Eval(number);
  for (int i = 0; i < number; ++i)
    if (!std::isfinite(values[i]))
      m_parser->refuse_value(values[i]);
  return values;
}

} // namespace dsc
