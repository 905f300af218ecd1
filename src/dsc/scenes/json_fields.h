// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_JSON_FIELDS_H
#define DSC_JSON_FIELDS_H

#include "input/expression.h"
#include "output/report_json.h"

namespace dsc {

/// The fields of an object of a JSON file. Checks that each field is known, of the correct type and
/// in its range. Points and vectors have the dimension of the scene, and so do those of all objects
/// in it.
class Json_fields
{
public:
  /// \param name name of the object, for messages
  /// \throws Usage_error if `json` is not an object
  Json_fields(const Json& json, std::string name, int dimension = 3);

  int dimension() const { return m_dimension; }
  void set_dimension(int dimension) { m_dimension = dimension; }

  /// Returns the names of the coordinates of points, and the names in `others`.
  std::vector<std::string> coordinate_names(const std::vector<std::string>& others = {}) const {
    return dsc::coordinate_names(m_dimension, others);
  }

  /// Checks that all fields are in the list. Must be called before fields are read, so that a
  /// misspelt field is reported before the missing field with the correct name.
  /// \throws Usage_error with the nearest known name if the object has another field
  void require_known(const std::vector<std::string>& fields) const;

  bool has(const std::string& field) const { return m_json->contains(field); }
  const std::string& name() const { return m_name; }
  /// Return the value of a field.
  /// \throws Usage_error if the field is missing; these and all following functions also throw it
  /// if the field has another type or is not finite
  const Json& any(const std::string& field) const;
  double number(const std::string& field) const;
  double number(const std::string& field, double otherwise) const;
  double positive(const std::string& field) const;
  /// Returns a number that is at least 0.
  double not_negative(const std::string& field, double otherwise) const;
  std::size_t count(const std::string& field, std::size_t otherwise) const;
  bool flag(const std::string& field, bool otherwise) const;
  std::string text(const std::string& field) const;
  std::string text(const std::string& field, const std::string& otherwise) const;
  /// Returns one of the given words.
  std::string choice(const std::string& field, const std::vector<std::string>& words) const;
  /// \param form expected form, for messages
  Expression expression(const std::string& field, const std::vector<std::string>& variables,
                        int size, const std::string& form) const;
  /// Returns a number as an expression, or an expression.
  Expression number_or_expression(const std::string& field,
                                  const std::vector<std::string>& variables,
                                  const std::string& form) const;
  /// Returns an expression in t for each coordinate of a vector.
  Expression vector_in_time(const std::string& field) const;
  template <std::size_t n> std::array<double, n> numbers(const std::string& field) const {
    std::array<double, n> result;
    read_numbers(field, n, result.data());
    return result;
  }
  /// Returns a point or a vector; in the plane, its third coordinate is 0.
  std::array<double, 3> point(const std::string& field) const;
  /// Returns the least and then the largest coordinates of a box; in the plane, those of z are 0.
  /// \throws Usage_error if the box is empty
  std::array<double, 6> box(const std::string& field) const;
  /// Returns the box with the corners `from` and `to`, in the same order.
  /// \throws Usage_error if the box is empty
  std::array<double, 6> corners() const;
  /// Returns the objects of a list; none if the list is missing.
  std::vector<Json_fields> objects(const std::string& field) const;
  Json_fields object(const std::string& field) const;
  /// \throws Usage_error if both fields are given
  void require_not_both(const std::string& field, const std::string& other) const;

  /// Throws an error for a field; the message begins with the place of the field.
  /// \throws Usage_error always
  [[noreturn]] void refuse(const std::string& field, const std::string& why) const;

private:
  double finite(const std::string& field, const Json& number) const;
  void read_numbers(const std::string& field, std::size_t n, double* result,
                    const std::string& reason = "") const;
  void read_coordinates(const std::string& field, std::size_t n, double* result) const;

  const Json* m_json;
  std::string m_name;
  int m_dimension;
};

} // namespace dsc

#endif // DSC_JSON_FIELDS_H
