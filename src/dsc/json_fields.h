// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_JSON_FIELDS_H
#define DSC_JSON_FIELDS_H

#include "expression.h"
#include "report_json.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace dsc {

/// The fields of an object of a JSON file. Each must be known, of the right type and in its range.
class Json_fields
{
public:
  /// \param name of the object, for messages. \throws Usage_error if it is none
  Json_fields(const Json& json, std::string name);

  /// To be called before fields are read, so that a misspelt field is found before the field that
  /// it was meant to be is missing. \throws Usage_error if the object has a field that is not in
  /// the list, with the nearest one
  void require_known(const std::vector<std::string>& fields) const;

  bool has(const std::string& field) const { return m_json->contains(field); }
  const std::string& name() const { return m_name; }
  /// \throws Usage_error if the field is missing; all below do so if it is of another type or not
  /// finite
  const Json& any(const std::string& field) const;
  double number(const std::string& field) const;
  double number(const std::string& field, double otherwise) const;
  double positive(const std::string& field) const;
  /// 0 or more.
  double not_negative(const std::string& field, double otherwise) const;
  std::size_t count(const std::string& field, std::size_t otherwise) const;
  bool flag(const std::string& field, bool otherwise) const;
  std::string text(const std::string& field) const;
  std::string text(const std::string& field, const std::string& otherwise) const;
  /// One of some words.
  std::string choice(const std::string& field, const std::vector<std::string>& words) const;
  /// \param form what is to be written there, for messages
  Expression expression(const std::string& field, const std::vector<std::string>& variables,
                        int size, const std::string& form) const;
  template <std::size_t n> std::array<double, n> numbers(const std::string& field) const {
    std::array<double, n> result;
    read_numbers(field, n, result.data());
    return result;
  }
  /// The objects of a list, none if it is missing.
  std::vector<Json_fields> objects(const std::string& field) const;
  Json_fields object(const std::string& field) const;

  /// \throws Usage_error that begins with the place of a field
  [[noreturn]] void refuse(const std::string& field, const std::string& why) const;

private:
  void read_numbers(const std::string& field, std::size_t n, double* result) const;

  const Json* m_json;
  std::string m_name;
};

} // namespace dsc

#endif // DSC_JSON_FIELDS_H
