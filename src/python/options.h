// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_PYTHON_OPTIONS_H
#define DSC_PYTHON_OPTIONS_H

#include <CGAL/Complex_construction/Construction_options.h>
#include <CGAL/Mesh_support/parameter_values.h>

#include <pybind11/functional.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <map>

namespace dsc_python {

namespace py = pybind11;

/// The names of the values of an enumeration.
template <class Enumeration> struct Names_of;

/// The named options of a function. Each option is read once.
class Options
{
public:
  explicit Options(const py::dict& options) : m_rest(options.attr("copy")()) {}

  /// Replaces `value` if the option is given and not None.
  /// \throws py::type_error if it is of another type
  template <class T> void read(const std::string& name, T& value) {
    const py::object option = take(name);
    if (option.is_none())
      return;
    try {
      value = option.cast<T>();
    } catch (const py::cast_error&) {
      throw py::type_error(name + " is of the wrong type: " + std::string(py::repr(option)));
    }
  }

  /// Replaces `value` if the option is given and not None, by the value with the name that is
  /// given. \throws py::value_error if there is no such name
  template <class T>
  void read_name(const std::string& name, const std::map<std::string, T>& values, T& value) {
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
    throw py::value_error(name + " must be one of " + names + ", not '" + given + "'");
  }

  /// Reads the numbers, truth values and names of a struct of options, and requires that no option
  /// is left. \param names the names of members that have another name in Python
  /// \throws py::type_error if an option is of another type or unknown
  template <class Struct>
  void read_all(Struct& options, std::map<std::string, std::string> names = {}) {
    names.insert({{"number_of_threads", "threads"},
                  {"maximum_number_of_passes", "maximum_passes"},
                  {"domain_rule", "domain"}});
    CGAL::Deformable_simplicial_complexes::for_each_option(
        options, [&](const std::string& member, auto& value) {
          using Value = std::decay_t<decltype(value)>;
          const auto found = names.find(member);
          const std::string& name = found == names.end() ? member : found->second;
          if constexpr (std::is_enum<Value>::value)
            read_name(name, Names_of<Value>::values, value);
          else if constexpr (std::is_assignable<Value&, double>::value)
            read(name, value);
        });
    require_all_read();
  }

  /// Removes and returns an option; None if it is not given.
  py::object take(const std::string& name) {
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

template <int d> using Box = std::pair<std::array<double, d>, std::array<double, d>>;

inline CGAL::Bbox_2 bbox_of(const Box<2>& box) {
  return {box.first[0], box.first[1], box.second[0], box.second[1]};
}

inline CGAL::Bbox_3 bbox_of(const Box<3>& box) {
  return {box.first[0], box.first[1], box.first[2], box.second[0], box.second[1], box.second[2]};
}

/// Reads the options of the functions that make a complex.
template <int d>
CGAL::Deformable_simplicial_complexes::Construction_options<d>
construction_options(const py::dict& options) {
  CGAL::Deformable_simplicial_complexes::Construction_options<d> result;
  Options rest(options);
  std::optional<Box<d>> box;
  rest.read("box", box);
  if (box)
    result.enclosing_box = bbox_of(*box);
  rest.read_all(result);
  return result;
}

} // namespace dsc_python

#endif // DSC_PYTHON_OPTIONS_H
