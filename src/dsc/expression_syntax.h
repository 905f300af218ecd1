// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_EXPRESSION_SYNTAX_H
#define DSC_EXPRESSION_SYNTAX_H

#include <stdexcept>
#include <string>
#include <vector>

namespace dsc {

/// The error thrown for a text that is not a valid expression.
class Syntax_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Translates expressions, separated by commas, into the syntax of muParser. A chain of comparisons
/// such as `a<b<=c` becomes `(a<b && b<=c)`. Throws for constructs that muParser would
/// misinterpret: assignments, chains with `==`, `!=` or both directions, and unknown names.
/// \throws Syntax_error
std::string translate_expressions(const std::string& text, const std::vector<std::string>& values,
                                  const std::vector<std::string>& functions);

} // namespace dsc

#endif // DSC_EXPRESSION_SYNTAX_H
