// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_EXPRESSION_SYNTAX_H
#define DSC_EXPRESSION_SYNTAX_H

#include <stdexcept>
#include <string>
#include <vector>

namespace dsc {

/// What is wrong with a text that is to be an expression.
class Syntax_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Translates expressions, with commas between them, into the language of muParser. A chain of
/// comparisons such as `a<b<=c` becomes `(a<b && b<=c)`. What muParser would misread is refused:
/// assignments, chains with `==`, `!=` or both directions, and names that are not known.
/// \throws Syntax_error
std::string translate_expressions(const std::string& text, const std::vector<std::string>& values,
                                  const std::vector<std::string>& functions);

} // namespace dsc

#endif // DSC_EXPRESSION_SYNTAX_H
