// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "json_fields.h"

#include "errors.h"

#include <cmath>
#include <utility>

namespace dsc {

Json_fields::Json_fields(const Json& json, std::string name)
    : m_json(&json), m_name(std::move(name)) {
  if (!json.is_object())
    throw Usage_error(m_name + " is no object in braces");
}

void Json_fields::refuse(const std::string& field, const std::string& why) const {
  throw Usage_error(m_name + ", field '" + field + "': " + why);
}

bool Json_fields::has(const std::string& field) const { return m_json->contains(field); }

const Json& Json_fields::any(const std::string& field) {
  m_known.insert(field);
  if (!has(field))
    throw Usage_error(m_name + " has no field '" + field + "', which it needs");
  return m_json->at(field);
}

double Json_fields::number(const std::string& field) {
  const Json& json = any(field);
  if (!json.is_number() || !std::isfinite(json.get<double>()))
    refuse(field, "a number is needed");
  return json.get<double>();
}

double Json_fields::number(const std::string& field, double otherwise) {
  m_known.insert(field);
  return has(field) ? number(field) : otherwise;
}

double Json_fields::positive(const std::string& field) {
  const double result = number(field);
  if (!(result > 0))
    refuse(field, "a positive number is needed");
  return result;
}

std::size_t Json_fields::count(const std::string& field, std::size_t otherwise) {
  m_known.insert(field);
  if (!has(field))
    return otherwise;
  static constexpr std::size_t most = 1000000000;
  const Json& json = any(field);
  if (!json.is_number_unsigned() || json.get<std::size_t>() > most)
    refuse(field, "a whole number of 0 or more is needed");
  return json.get<std::size_t>();
}

bool Json_fields::flag(const std::string& field, bool otherwise) {
  m_known.insert(field);
  if (!has(field))
    return otherwise;
  if (!any(field).is_boolean())
    refuse(field, "true or false is needed");
  return any(field).get<bool>();
}

std::string Json_fields::text(const std::string& field) {
  const Json& json = any(field);
  if (!json.is_string())
    refuse(field, "a text in quotes is needed");
  return json.get<std::string>();
}

std::string Json_fields::text(const std::string& field, const std::string& otherwise) {
  m_known.insert(field);
  return has(field) ? text(field) : otherwise;
}

void Json_fields::read_numbers(const std::string& field, std::size_t n, double* result) {
  const Json& json = any(field);
  bool fits = json.is_array() && json.size() == n;
  for (std::size_t i = 0; fits && i < n; ++i) {
    fits = json[i].is_number() && std::isfinite(json[i].get<double>());
    if (fits)
      result[i] = json[i].get<double>();
  }
  if (!fits)
    refuse(field, "a list of " + std::to_string(n) + " numbers is needed");
}

std::vector<Json_fields> Json_fields::objects(const std::string& field) {
  m_known.insert(field);
  std::vector<Json_fields> result;
  if (!has(field))
    return result;
  const Json& json = any(field);
  if (!json.is_array())
    refuse(field, "a list in brackets is needed");
  for (std::size_t i = 0; i < json.size(); ++i)
    result.emplace_back(json[i], field + "[" + std::to_string(i) + "] of " + m_name);
  return result;
}

Json_fields Json_fields::object(const std::string& field) {
  return {any(field), field + " of " + m_name};
}

void Json_fields::close() const {
  for (const auto& [field, value] : m_json->items())
    if (m_known.count(field) == 0) {
      std::string known;
      for (const std::string& name : m_known)
        known += (known.empty() ? "" : ", ") + name;
      throw Usage_error(m_name + " has the field '" + field + "', which nobody knows; fields are " +
                        known);
    }
}

} // namespace dsc
