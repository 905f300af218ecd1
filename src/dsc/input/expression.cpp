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
#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace dsc {
namespace {

/// The error thrown for a text that is not a valid expression.
class Syntax_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

struct Token
{
  enum class Kind { number, name, sign, end };

  Kind kind;
  std::string text;
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

/// A tokenizer.
class Tokens
{
public:
  explicit Tokens(const std::string& text) : m_text(text) { take(); }

  const Token& next() const { return m_next; }
  bool is_next(const std::string& sign) const {
    return m_next.kind == Token::Kind::sign && m_next.text == sign;
  }

  Token take() {
    Token result = std::move(m_next);
    while (m_place < m_text.size() && std::isspace(static_cast<unsigned char>(m_text[m_place])))
      ++m_place;
    const std::size_t begin = m_place;
    if (begin == m_text.size()) {
      m_next = {Token::Kind::end, ""};
      return result;
    }
    Token::Kind kind = Token::Kind::sign;
    if (is_digit(at(0)) || (at(0) == '.' && is_digit(at(1)))) {
      kind = Token::Kind::number;
      pass_number();
    } else if (is_letter(at(0))) {
      kind = Token::Kind::name;
      while (is_letter(at(0)) || is_digit(at(0)))
        ++m_place;
    } else {
      pass_sign();
    }
    m_next = {kind, m_text.substr(begin, m_place - begin)};
    return result;
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
  Token m_next = {Token::Kind::end, ""};
};

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// A recursive descent parser with a function for each operator precedence, lowest precedence
/// first. Each function returns its part of the expression in the syntax of muParser.
class Translator
{
public:
  Translator(const std::string& text, const std::vector<std::string>& values,
             const std::vector<std::string>& functions)
      : m_tokens(text), m_values(values), m_functions(functions) {}

  std::string translate() {
    std::string result = list();
    if (m_tokens.next().kind != Token::Kind::end)
      throw Syntax_error(quoted(m_tokens.next().text) + " is unexpected" +
                         (m_tokens.is_next(")") ? ": no parenthesis is open" : ""));
    return result;
  }

private:
  std::string list() {
    std::string result = choice();
    while (m_tokens.is_next(",")) {
      result += take();
      result += choice();
    }
    return result;
  }

  std::string choice() {
    std::string result = disjunction();
    if (!m_tokens.is_next("?"))
      return result;
    const Nesting nesting(*this);
    result += take();
    result += choice();
    if (!m_tokens.is_next(":"))
      throw Syntax_error("':' is missing after '?'; write it like 'x<0?-1:1'");
    result += take();
    return result + choice();
  }

  std::string disjunction() {
    std::string result = conjunction();
    while (m_tokens.is_next("||")) {
      result += take();
      result += conjunction();
    }
    return result;
  }

  std::string conjunction() {
    std::string result = comparison();
    while (m_tokens.is_next("&&")) {
      result += take();
      result += comparison();
    }
    return result;
  }

  std::string comparison() {
    std::vector<std::string> sides = {sum()}, signs;
    while (is_comparison()) {
      signs.push_back(take());
      sides.push_back(sum());
    }
    if (signs.size() < 2)
      return signs.empty() ? sides[0] : sides[0] + signs[0] + sides[1];
    const char direction = signs[0][0];
    std::string result;
    for (std::size_t i = 0; i < signs.size(); ++i) {
      if (signs[i][0] != direction || direction == '=' || direction == '!')
        throw Syntax_error(
            "a chain of comparisons must contain only '<' and '<=', or only '>' and '>='; "
            "join other comparisons by '&&'");
      result += (i > 0 ? "&& " : "") + sides[i] + signs[i] + sides[i + 1];
    }
    return limited("( " + result + ") ");
  }

  bool is_comparison() const {
    for (const char* sign : {"<", "<=", ">", ">=", "==", "!="})
      if (m_tokens.is_next(sign))
        return true;
    return false;
  }

  std::string sum() {
    std::string result = operand();
    for (;;) {
      bool goes_on = false;
      for (const char* sign : {"+", "-", "*", "/", "^"})
        goes_on = goes_on || m_tokens.is_next(sign);
      if (!goes_on)
        return limited(std::move(result));
      result += take();
      result += operand();
    }
  }

  std::string operand() {
    bool is_negative = false;
    while (m_tokens.is_next("+") || m_tokens.is_next("-"))
      is_negative ^= m_tokens.take().text == "-";
    const std::string result = (is_negative ? "- " : "") + primary();
    if (m_tokens.next().kind == Token::Kind::number || m_tokens.next().kind == Token::Kind::name ||
        m_tokens.is_next("("))
      throw Syntax_error("an operator is missing before " + quoted(m_tokens.next().text) +
                         "; write products with '*'");
    return result;
  }

  std::string primary() {
    if (m_tokens.is_next("("))
      return in_parentheses(false);
    if (m_tokens.next().kind == Token::Kind::number)
      return take();
    if (m_tokens.next().kind != Token::Kind::name)
      throw Syntax_error("a value is missing " + (m_tokens.next().kind == Token::Kind::end
                                                      ? std::string("at the end")
                                                      : "before " + quoted(m_tokens.next().text)));
    const std::string name = m_tokens.next().text;
    if (contains(m_values, name))
      return take();
    if (!contains(m_functions, name)) {
      std::vector<std::string> known = m_values;
      known.insert(known.end(), m_functions.begin(), m_functions.end());
      const bool is_misspelt = !nearest_name(name, known).empty();
      throw Syntax_error("the name " + quoted(name) + " is unknown" +
                         advice_on_name(name, is_misspelt ? known : m_values, "variables"));
    }
    m_tokens.take();
    if (!m_tokens.is_next("("))
      throw Syntax_error("the function " + quoted(name) + " needs parentheses, like " + name +
                         "(x)");
    return name + in_parentheses(true); // muParser allows no space between them
  }

  std::string in_parentheses(bool is_list) {
    const Nesting nesting(*this);
    std::string result = take();
    result += is_list ? list() : choice();
    if (!m_tokens.is_next(")"))
      throw Syntax_error(m_tokens.next().kind == Token::Kind::end
                             ? std::string("a parenthesis is not closed")
                             : quoted(m_tokens.next().text) + " is unexpected");
    return result + take();
  }

  std::string take() { return m_tokens.take().text + ' '; }

  /// Returns the text, and throws if it is too long: nested chains of comparisons repeat their
  /// operands.
  static std::string limited(std::string text) {
    static constexpr std::size_t most = 10000; // characters, within the limits of muParser
    if (text.size() > most)
      throw Syntax_error("the expression is too long");
    return text;
  }

  struct Nesting
  {
    explicit Nesting(Translator& translator) : m_depth(translator.m_depth) {
      static constexpr int most = 100; // nesting depth, limits the stack
      if (++m_depth > most)
        throw Syntax_error("the expression is nested too deeply");
    }
    ~Nesting() { --m_depth; }
    int& m_depth;
  };

  Tokens m_tokens;
  const std::vector<std::string>&m_values, &m_functions;
  int m_depth = 0;
};

/// Translates expressions, separated by commas, into the syntax of muParser. A chain of comparisons
/// such as `a<b<=c` becomes `(a<b && b<=c)`. Throws for constructs that muParser would
/// misinterpret: assignments, chains with `==`, `!=` or both directions, and unknown names.
/// \throws Syntax_error
std::string translate_expressions(const std::string& text, const std::vector<std::string>& values,
                                  const std::vector<std::string>& functions) {
  return Translator(text, values, functions).translate();
}

} // namespace

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
