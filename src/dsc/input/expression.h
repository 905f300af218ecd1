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

/// Returns the names of the coordinates of points, and of other variables after them.
std::vector<std::string> coordinate_names(int dimension,
                                          const std::vector<std::string>& others = {});

/// One or several expressions of the command line or of a scene, separated by commas. The syntax is
/// the one of muParser, with `pi` and chained comparisons, but without assignments. Copies share
/// the parser, so that only one thread may evaluate them.
class Expression
{
public:
  /// \param variables names of the variables
  /// \param place description of the expression for messages, for example "--velocity"
  /// \param form expected form, for messages
  /// \throws Usage_error with the reason if the expression cannot be read
  Expression(const std::string& text, const std::vector<std::string>& variables,
             const std::string& place, const std::string& form);

  /// Returns the number of values, which are separated by commas.
  int size() const { return m_size; }
  bool depends_on(const std::string& variable) const;
  bool is_constant() const;

  /// Evaluates the expressions. The returned values are valid until the next call.
  /// \param variables values of the variables, in the order of their names
  /// \throws Input_error with the place if a value is not finite
  const double* at(std::initializer_list<double> variables) const;

  /// Evaluates the expressions at a point in the plane or in space.
  /// \param others values of the variables after the coordinates
  template <class Point, class... Others>
  const double* at_point(const Point& p, int dimension, Others... others) const {
    return dimension == 2 ? at({p[0], p[1], others...}) : at({p[0], p[1], p[2], others...});
  }

  /// Throws an error for the expression, with the reason and the expected form.
  /// \throws Usage_error always
  [[noreturn]] void refuse(const std::string& why) const;

private:
  struct Parser;
  std::shared_ptr<Parser> m_parser;
  int m_size = 0;
};

} // namespace dsc

#endif // DSC_EXPRESSION_H
