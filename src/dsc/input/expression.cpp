// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/expression.h"

#include "input/nearest_name.h"
#include "programs/errors.h"

#include <CGAL/number_utils.h>

#include <muParser.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>
#include <utility>

namespace dsc {
namespace {

/// The error thrown for a text that is not a valid expression.
class Syntax_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

std::string quoted(const std::string& text) { return "'" + text + "'"; }

/// Returns notations of other languages, and their replacements. Longer notations come first.
const std::vector<std::pair<std::string, std::string>>& foreign_signs() {
  static const std::vector<std::pair<std::string, std::string>> result = {
      {"**", "^"}, {"=<", "<="}, {"=>", ">="}, {"<>", "!="}, {"[", "("},     {"]", ")"},
      {"{", "("},  {"}", ")"},   {";", ","},   {"&", "&&"},  {"|", "||"},    {"×", "*"},
      {"·", "*"},  {"÷", "/"},   {"−", "-"},   {"–", "-"},   {"²", "^2"},    {"³", "^3"},
      {"≤", "<="}, {"≥", ">="},  {"≠", "!="},  {"π", "pi"},  {"√", "sqrt()"}};
  return result;
}

bool is_letter(char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return '0' <= c && c <= '9'; }

bool is_number(const std::string& token) {
  return !token.empty() && (is_digit(token[0]) || token[0] == '.');
}
bool is_name(const std::string& token) { return !token.empty() && is_letter(token[0]); }

/// Splits a text into numbers, names and signs.
class Tokenizer
{
public:
  explicit Tokenizer(const std::string& text) : m_text(text) {}

  /// Returns the next token; an empty one at the end.
  std::string take() {
    while (std::isspace(static_cast<unsigned char>(at(0))))
      ++m_place;
    const std::size_t begin = m_place;
    if (begin == m_text.size())
      return "";
    if (is_digit(at(0)) || (at(0) == '.' && is_digit(at(1))))
      pass_number();
    else if (is_letter(at(0)))
      while (is_letter(at(0)) || is_digit(at(0)))
        ++m_place;
    else
      pass_sign();
    return m_text.substr(begin, m_place - begin);
  }

private:
  char at(std::size_t offset) const {
    return m_place + offset < m_text.size() ? m_text[m_place + offset] : '\0';
  }
  bool starts_with(const std::string& sign) const {
    return m_text.compare(m_place, sign.size(), sign) == 0;
  }

  void pass_digits() {
    while (is_digit(at(0)))
      ++m_place;
  }

  void pass_number() {
    const std::size_t begin = m_place;
    pass_digits();
    if (at(0) == '.')
      ++m_place;
    pass_digits();
    if (at(0) == 'e' || at(0) == 'E') {
      ++m_place;
      if (at(0) == '+' || at(0) == '-')
        ++m_place;
      if (!is_digit(at(0)))
        throw Syntax_error("the number " + quoted(m_text.substr(begin, m_place - begin)) +
                           " has no digits after its e");
      pass_digits();
    }
    if (at(0) == '.')
      throw Syntax_error("the number " + quoted(m_text.substr(begin, m_place + 1 - begin)) +
                         " has two decimal points");
  }

  void pass_sign() {
    for (const char* sign : {"<=", ">=", "==", "!=", "&&", "||"})
      if (starts_with(sign)) {
        m_place += 2;
        return;
      }
    for (const auto& [sign, ours] : foreign_signs())
      if (starts_with(sign))
        throw Syntax_error(quoted(sign) + " is unknown; write " + quoted(ours));
    static const std::string signs = "+-*/^<>?:(),";
    if (signs.find(at(0)) != std::string::npos) {
      ++m_place;
      return;
    }
    if (at(0) == '=')
      throw Syntax_error("'=' is an assignment; write '==' to compare two values");
    if (at(0) == '!')
      throw Syntax_error("'!' is unknown; write '(...)==0' to negate a condition");
    refuse_character();
  }

  [[noreturn]] void refuse_character() const {
    const auto code = static_cast<unsigned char>(at(0));
    if (code < ' ' || code == 127)
      throw Syntax_error("the control character with code " + std::to_string(code) + " is unknown");
    std::size_t end = m_place + 1; // includes all bytes of a UTF-8 character
    while (end < m_text.size() && (static_cast<unsigned char>(m_text[end]) & 0xC0) == 0x80)
      ++end;
    throw Syntax_error("the character " + quoted(m_text.substr(m_place, end - m_place)) +
                       " is unknown");
  }

  const std::string& m_text;
  std::size_t m_place = 0;
};

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Rewrites expressions, separated by commas, for muParser, which knows their grammar. A chain of
/// comparisons such as `a<b<=c` becomes `(a<b && b<=c)`; repeated signs and spaces before
/// parentheses vanish. Each token is only checked against the token before it and the open
/// parentheses, for messages with a remedy, and because muParser misinterprets some errors.
class Rewriter
{
public:
  Rewriter(const std::vector<std::string>& values, const std::vector<std::string>& functions)
      : m_values(values), m_functions(functions) {}

  /// \throws Syntax_error
  std::string rewrite(const std::string& text) {
    Tokenizer tokens(text);
    std::string token;
    do {
      token = tokens.take();
      if (m_is_value_next)
        read_value(token);
      else
        read_operator(token);
    } while (!token.empty());
    return m_levels.back().complete;
  }

private:
  /// The part of the expressions in a pair of parentheses.
  struct Level
  {
    bool is_list = true;                          // of arguments, or of all expressions
    std::string complete;                         // rewritten until the current comparison
    std::vector<std::string> sides = {""}, signs; // of the current comparison
    int open_choices = 0;                         // number of `?` whose `:` is missing
  };

  void read_value(const std::string& token) {
    if (!m_function.empty() && token != "(")
      throw Syntax_error("the function " + quoted(std::as_const(m_function)) +
                         " needs parentheses, like " + m_function + "(x)");
    if (token == "+" || token == "-") {
      m_is_negative ^= token == "-";
      return;
    }
    std::string& side = m_levels.back().sides.back();
    side += std::exchange(m_is_negative, false) ? "- " : "";
    if (token == "(") {
      side += "( ";
      open_parenthesis();
    } else if (is_number(token) || contains(m_values, token)) {
      side += token + ' ';
      m_is_value_next = false;
    } else if (contains(m_functions, token)) {
      side += token; // muParser allows no space between them
      m_function = token;
    } else {
      refuse_value(token);
    }
  }

  void open_parenthesis() {
    static constexpr std::size_t most = 100; // nested parentheses
    m_levels.emplace_back();
    m_levels.back().is_list = !std::exchange(m_function, "").empty();
    if (m_levels.size() > most + 1)
      throw Syntax_error("the expression is nested too deeply");
  }

  [[noreturn]] void refuse_value(const std::string& token) const {
    if (!is_name(token))
      throw Syntax_error("a value is missing " +
                         (token.empty() ? std::string("at the end") : "before " + quoted(token)));
    std::vector<std::string> known = m_values;
    known.insert(known.end(), m_functions.begin(), m_functions.end());
    const bool is_misspelt = !nearest_name(token, known).empty();
    throw Syntax_error("the name " + quoted(token) + " is unknown" +
                       advice_on_name(token, is_misspelt ? known : m_values, "variables"));
  }

  void read_operator(const std::string& token) {
    if (is_number(token) || is_name(token) || token == "(")
      throw Syntax_error("an operator is missing before " + quoted(token) +
                         "; write products with '*'");
    m_is_value_next = token != ")";
    Level& level = m_levels.back();
    if (token.find_first_of("<>=!") == 0) {
      level.signs.push_back(token + ' ');
      level.sides.emplace_back();
    } else if (token.find_first_of("+-*/^") == 0) {
      level.sides.back() += token + ' ';
    } else {
      complete_comparison();
      check_end_of_comparison(token);
      level.complete += token + ' ';
      if (token == ")") {
        const std::string part = std::move(level.complete);
        m_levels.pop_back();
        m_levels.back().sides.back() += part;
      }
    }
  }

  void complete_comparison() {
    static constexpr std::size_t most = 10000; // characters, because chains repeat their operands
    auto& [is_list, complete, sides, signs, open_choices] = m_levels.back();
    std::string text = sides[0];
    for (std::size_t i = 0; i < signs.size(); ++i) {
      if (signs.size() > 1 && (signs[i][0] != signs[0][0] || signs[i].find_first_of("=!") == 0))
        throw Syntax_error(
            "a chain of comparisons must contain only '<' and '<=', or only '>' and '>='; "
            "join other comparisons by '&&'");
      text += (i > 0 ? "&& " + sides[i] : "") + signs[i] + sides[i + 1];
    }
    if (text.size() > most)
      throw Syntax_error("the expression is too long");
    complete += signs.size() > 1 ? "( " + text + ") " : text;
    sides.assign(1, "");
    signs.clear();
  }

  /// Checks the token after a comparison: a comma, a parenthesis, the end, or an operator of lower
  /// precedence.
  void check_end_of_comparison(const std::string& token) {
    Level& level = m_levels.back();
    level.open_choices += token == "?" ? 1 : token == ":" ? -1 : 0;
    if (level.open_choices > 0 && (token == "," || token == ")" || token.empty()))
      throw Syntax_error("':' is missing after '?'; write it like 'x<0?-1:1'");
    const bool is_in_parentheses = m_levels.size() > 1;
    if (token.empty() && is_in_parentheses)
      throw Syntax_error("a parenthesis is not closed");
    if (level.open_choices < 0 || (token == "," && !level.is_list))
      throw Syntax_error(quoted(token) + " is unexpected");
    if (token == ")" && !is_in_parentheses)
      throw Syntax_error("')' is unexpected: no parenthesis is open");
  }

  const std::vector<std::string>&m_values, &m_functions;
  std::vector<Level> m_levels = std::vector<Level>(1);
  bool m_is_value_next = true, m_is_negative = false;
  std::string m_function; // whose parentheses follow
};

} // namespace

std::vector<std::string> coordinate_names(int dimension, const std::vector<std::string>& others) {
  std::vector<std::string> result = {"x", "y", "z"};
  result.resize(std::size_t(dimension));
  result.insert(result.end(), others.begin(), others.end());
  return result;
}

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
    parser.SetExpr(Rewriter(values, functions).rewrite(text));
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
