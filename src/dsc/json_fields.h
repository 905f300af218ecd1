// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_JSON_FIELDS_H
#define DSC_JSON_FIELDS_H

#include "report_json.h"

#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace dsc {

/// The fields of an object of a JSON file, each of which must be known, of the right type and in
/// its range.
class Json_fields
{
public:
  /// \param name of the object, for messages. \throws Usage_error if it is none
  Json_fields(const Json& json, std::string name);

  bool has(const std::string& field) const;
  /// \throws Usage_error if the field is missing; all below do so if it is of another type or not
  /// finite
  const Json& any(const std::string& field);
  double number(const std::string& field);
  double number(const std::string& field, double otherwise);
  double positive(const std::string& field);
  std::size_t count(const std::string& field, std::size_t otherwise);
  bool flag(const std::string& field, bool otherwise);
  std::string text(const std::string& field);
  std::string text(const std::string& field, const std::string& otherwise);
  template <std::size_t n> std::array<double, n> numbers(const std::string& field) {
    std::array<double, n> result;
    read_numbers(field, n, result.data());
    return result;
  }
  /// The objects of a list, none if it is missing.
  std::vector<Json_fields> objects(const std::string& field);
  Json_fields object(const std::string& field);

  /// \throws Usage_error if there is a field that nobody has asked for
  void close() const;

  /// \throws Usage_error that begins with the place of a field
  [[noreturn]] void refuse(const std::string& field, const std::string& why) const;

private:
  void read_numbers(const std::string& field, std::size_t n, double* result);

  const Json* m_json;
  std::string m_name;
  std::set<std::string> m_known;
};

} // namespace dsc

#endif // DSC_JSON_FIELDS_H
