// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenes/json_fields.h"

#include "input/nearest_name.h"
#include "programs/errors.h"

#include <algorithm>
#include <cmath>

namespace dsc {

Json_fields::Json_fields(const Json& json, std::string name, int dimension)
    : m_json(&json), m_name(std::move(name)), m_dimension(dimension) {
  if (!json.is_object())
    throw Usage_error(m_name + " must be an object in braces");
}

void Json_fields::refuse(const std::string& field, const std::string& why) const {
  throw Usage_error(m_name + ", field '" + field + "': " + why);
}

void Json_fields::require_known(const std::vector<std::string>& fields) const {
  for (const auto& [field, value] : m_json->items())
    if (std::find(fields.begin(), fields.end(), field) == fields.end())
      throw Usage_error(m_name + " has the unknown field '" + field + "'" +
                        advice_on_name(field, fields, "known fields"));
}

const Json& Json_fields::any(const std::string& field) const {
  if (!has(field))
    throw Usage_error(m_name + " lacks the required field '" + field + "'; add it");
  return m_json->at(field);
}

/// Returns a finite number. Files contain no others, but Python does.
double Json_fields::finite(const std::string& field, const Json& number) const {
  if (!std::isfinite(number.get<double>()))
    refuse(field, "must be finite");
  return number.get<double>();
}

double Json_fields::number(const std::string& field) const {
  const Json& json = any(field);
  if (!json.is_number())
    refuse(field, json.is_string() ? "must be a number, without quotes" : "must be a number");
  return finite(field, json);
}

double Json_fields::number(const std::string& field, double otherwise) const {
  return has(field) ? number(field) : otherwise;
}

double Json_fields::positive(const std::string& field) const {
  const double result = number(field);
  if (!(result > 0))
    refuse(field, "must be a positive number");
  return result;
}

double Json_fields::not_negative(const std::string& field, double otherwise) const {
  const double result = number(field, otherwise);
  if (!(result >= 0))
    refuse(field, "must be 0 or more");
  return result;
}

std::size_t Json_fields::count(const std::string& field, std::size_t otherwise) const {
  if (!has(field))
    return otherwise;
  static constexpr std::size_t most = 1000000000;
  const Json& json = any(field);
  if (!json.is_number_unsigned() || json.get<std::size_t>() > most)
    refuse(field, "must be an integer from 0 to 1000000000");
  return json.get<std::size_t>();
}

bool Json_fields::flag(const std::string& field, bool otherwise) const {
  if (!has(field))
    return otherwise;
  if (!any(field).is_boolean())
    refuse(field, "must be true or false");
  return any(field).get<bool>();
}

std::string Json_fields::text(const std::string& field) const {
  const Json& json = any(field);
  if (!json.is_string())
    refuse(field, "must be a string in quotes");
  return json.get<std::string>();
}

std::string Json_fields::text(const std::string& field, const std::string& otherwise) const {
  return has(field) ? text(field) : otherwise;
}

std::string Json_fields::choice(const std::string& field,
                                const std::vector<std::string>& words) const {
  const std::string result = text(field);
  if (std::find(words.begin(), words.end(), result) == words.end())
    refuse(field, "'" + result + "' is unknown" + advice_on_name(result, words, "known values"));
  return result;
}

Expression Json_fields::expression(const std::string& field,
                                   const std::vector<std::string>& variables, int size,
                                   const std::string& form) const {
  const Expression result(text(field), variables, field + " of " + m_name, form);
  if (result.size() != size)
    result.refuse("has " + std::to_string(result.size()) +
                  noun(std::size_t(result.size()), " component", " components") + " instead of " +
                  std::to_string(size));
  return result;
}

Expression Json_fields::number_or_expression(const std::string& field,
                                             const std::vector<std::string>& variables,
                                             const std::string& form) const {
  return any(field).is_string()
             ? expression(field, variables, 1, form)
             : Expression(Json(number(field)).dump(), variables, field + " of " + m_name, form);
}

Expression Json_fields::vector_in_time(const std::string& field) const {
  return expression(field, {"t"}, m_dimension,
                    m_dimension == 2 ? "two expressions in t like '0,0.1*sin(t)'"
                                     : "three expressions in t like '0,0,0.1*sin(t)'");
}

void Json_fields::read_numbers(const std::string& field, std::size_t n, double* result,
                               const std::string& reason) const {
  const Json& json = any(field);
  bool fits = json.is_array() && json.size() == n;
  for (std::size_t i = 0; fits && i < n; ++i) {
    fits = json[i].is_number();
    if (fits)
      result[i] = finite(field, json[i]);
  }
  if (!fits)
    refuse(field, "must be a list of " + std::to_string(n) + " numbers" + reason);
}

/// Reads numbers whose count depends on the dimension.
void Json_fields::read_coordinates(const std::string& field, std::size_t n, double* result) const {
  read_numbers(field, n, result,
               m_dimension == 2 ? " because the scene is in the plane: its 'domain' has 4 numbers"
                                : " because the scene is in space: its 'domain' has 6 numbers");
}

std::array<double, 3> Json_fields::point(const std::string& field) const {
  std::array<double, 3> result = {};
  read_coordinates(field, std::size_t(m_dimension), result.data());
  return result;
}

std::array<double, 6> Json_fields::box(const std::string& field) const {
  const auto d = std::size_t(m_dimension);
  std::array<double, 6> numbers = {}, result = {};
  read_coordinates(field, 2 * d, numbers.data());
  for (std::size_t i = 0; i < d; ++i) {
    result[i] = numbers[i];
    result[i + 3] = numbers[i + d];
    if (!(result[i + 3] > result[i]))
      refuse(field, std::string("must be ") + (d == 2 ? "two" : "three") +
                        " minimum coordinates and " + (d == 2 ? "two" : "three") +
                        " larger maximum coordinates");
  }
  return result;
}

std::array<double, 6> Json_fields::corners() const {
  const auto from = point("from"), to = point("to");
  std::array<double, 6> result = {};
  for (std::size_t i = 0; i < std::size_t(m_dimension); ++i) {
    result[i] = from[i];
    result[i + 3] = to[i];
    if (!(to[i] > from[i]))
      refuse("to", "must be larger than 'from' in each coordinate: the box is empty");
  }
  return result;
}

std::vector<Json_fields> Json_fields::objects(const std::string& field) const {
  std::vector<Json_fields> result;
  if (!has(field))
    return result;
  const Json& json = any(field);
  if (!json.is_array())
    refuse(field, "must be a list in brackets");
  for (std::size_t i = 0; i < json.size(); ++i)
    result.emplace_back(json[i], field + "[" + std::to_string(i) + "] of " + m_name, m_dimension);
  return result;
}

Json_fields Json_fields::object(const std::string& field) const {
  return {any(field), field + " of " + m_name, m_dimension};
}

void Json_fields::require_not_both(const std::string& field, const std::string& other) const {
  if (has(field) && has(other))
    refuse(field, "cannot be combined with the field '" + other + "'; remove one of them");
}

} // namespace dsc
