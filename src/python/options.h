// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_PYTHON_OPTIONS_H
#define DSC_PYTHON_OPTIONS_H

#include <pybind11/functional.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <map>
#include <string>

namespace dsc_python {

namespace py = pybind11;

/// The named options of a function. Each option is read once.
class Options
{
public:
  explicit Options(const py::dict& options) : m_rest(options.attr("copy")()) {}

  /// Replaces `value` if the option is given and not None.
  /// \throws py::type_error if it is of another type
  template <class T> void read(const char* name, T& value) {
    const py::object option = take(name);
    if (option.is_none())
      return;
    try {
      value = option.cast<T>();
    } catch (const py::cast_error&) {
      throw py::type_error(std::string(name) +
                           " is of the wrong type: " + std::string(py::repr(option)));
    }
  }

  /// Replaces `value` if the option is given and not None, by the value with the name that is
  /// given. \throws py::value_error if there is no such name
  template <class T>
  void read_name(const char* name, const std::map<std::string, T>& values, T& value) {
    std::string given;
    read(name, given);
    if (given.empty())
      return;
    const auto found = values.find(given);
    if (found != values.end()) {
      value = found->second;
      return;
    }
    std::string names;
    for (const auto& known : values)
      names += (names.empty() ? "'" : ", '") + known.first + "'";
    throw py::value_error(std::string(name) + " must be one of " + names + ", not '" + given + "'");
  }

  /// Removes and returns an option; None if it is not given.
  py::object take(const char* name) {
    return m_rest.attr("pop")(name, py::none()).cast<py::object>();
  }

  /// \throws py::type_error if options are left that no function has read
  void require_all_read() const {
    for (const auto& option : m_rest)
      throw py::type_error("unknown option '" + option.first.cast<std::string>() + "'");
  }

private:
  py::dict m_rest;
};

} // namespace dsc_python

#endif // DSC_PYTHON_OPTIONS_H
