// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_EXPRESSION_H
#define DSC_EXPRESSION_H

#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

namespace dsc {

/// An expression of the command line or of a scene, or several with commas between them: what
/// muParser knows, with `pi` and chains of comparisons, but without assignments. Copies share the
/// parser, so that only one thread may evaluate.
class Expression
{
public:
  /// \param variables names of the values that it may depend on
  /// \param place what the expression is, for messages, like "--velocity"
  /// \param form what is to be written there, for messages
  /// \throws Usage_error if it cannot be read, with what is wrong
  Expression(const std::string& text, const std::vector<std::string>& variables,
             const std::string& place, const std::string& form);

  /// How many values there are, with commas between them.
  int size() const { return m_size; }
  bool depends_on(const std::string& variable) const;
  bool is_constant() const;

  /// The values; they stay until the next call.
  /// \param variables their values, in the order of their names
  /// \throws Input_error if one is not finite, with the place
  const double* at(std::initializer_list<double> variables) const;

  /// \throws Usage_error that begins with the expression and ends with what is to be written
  [[noreturn]] void refuse(const std::string& why) const;

private:
  struct Parser;
  std::shared_ptr<Parser> m_parser;
  int m_size = 0;
};

} // namespace dsc

#endif // DSC_EXPRESSION_H
