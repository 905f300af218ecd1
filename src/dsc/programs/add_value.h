// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_ADD_VALUE_H
#define DSC_ADD_VALUE_H

#include "programs/option_values.h"

#include <CLI/CLI.hpp>

namespace dsc {

/// Adds an option that keeps the default of a value unless it is given.
/// \param read returns the value of a text, like a `Number_range`; receives the text and the name
/// of the option
template <class Value, class Read>
CLI::Option* add_value(CLI::App& command, const std::string& name, Value& value, const Read& read,
                       const std::string& description) {
  return command.add_option_function<std::string>(
      name, [&value, read, name](const std::string& text) { value = read(text, name); },
      description);
}

/// Adds an option whose values have names.
template <class Value>
CLI::Option* add_value(CLI::App& command, const std::string& name, Value& value,
                       const std::map<std::string, Value>& names, const std::string& description) {
  const auto read = [&names](const std::string& text, const std::string&) {
    return names.at(text);
  };
  return add_value(command, name, value, read, description)
      ->check(CLI::IsMember(&names))
      ->default_str(name_of(names, value));
}

} // namespace dsc

#endif // DSC_ADD_VALUE_H
