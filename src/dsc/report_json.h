// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_REPORT_JSON_H
#define DSC_REPORT_JSON_H

#include "statistics.h"

#include <nlohmann/json.hpp>

#include <string>

namespace dsc {

using Json = nlohmann::ordered_json;

template <class T> Json value_or_null(const T& value) {
  return value == T() ? Json() : Json(value);
}

/// The inverse.
template <class T> T value_of(const Json& json) { return json.is_null() ? T() : json.get<T>(); }

/// What all reports tell of a state.
Json statistics_json(const Statistics& statistics);

/// Writes a file in one go, so that it is whole whenever the program ends.
/// \throws std::runtime_error if that fails
void write_json(const std::string& path, const Json& json);

} // namespace dsc

#endif // DSC_REPORT_JSON_H
