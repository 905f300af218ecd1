// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "inequalities.h"

#include "errors.h"

#include <CGAL/number_utils.h>

#include <muParser.h>

#include <deque>

namespace dsc {

struct Inequalities::Parsers
{
  std::array<double, 3> variables = {};
  std::deque<mu::Parser> parsers; // which stay where they are
};

Inequalities::Inequalities(const std::vector<std::string>& expressions)
    : m_parsers(std::make_shared<Parsers>()) {
  static const std::array<const char*, 3> names = {"x", "y", "z"};
  for (const std::string& expression : expressions) {
    int number = 0;
    try {
      mu::Parser& parser = m_parsers->parsers.emplace_back();
      for (std::size_t i = 0; i < names.size(); ++i)
        parser.DefineVar(names[i], &m_parsers->variables[i]);
      parser.DefineConst("pi", CGAL_PI);
      parser.SetExpr(expression);
      parser.Eval(number);
    } catch (const mu::Parser::exception_type& error) {
      throw Usage_error("'" + expression + "' cannot be read: " + error.GetMsg() +
                        "; write an inequality in x, y and z like 'x^2+y^2+z^2<1'");
    }
    if (number != 1)
      throw Usage_error("'" + expression +
                        "' has commas: write several inequalities as several "
                        "INPUTs, or with && and || between them");
  }
}

int Inequalities::label_at(const std::array<double, 3>& p) const {
  m_parsers->variables = p;
  for (std::size_t i = m_parsers->parsers.size(); i > 0; --i)
    if (m_parsers->parsers[i - 1].Eval() != 0)
      return static_cast<int>(i);
  return 0;
}

} // namespace dsc
