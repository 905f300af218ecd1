// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_REPORT_JSON_H
#define DSC_REPORT_JSON_H

#include "output/statistics.h"

#include <CGAL/Mesh_files/Label_names.h>

#include <nlohmann/json.hpp>

namespace dsc {

using Json = nlohmann::ordered_json;

template <class T> Json value_or_null(const T& value) {
  return value == T() ? Json() : Json(value);
}

template <class T> Json value_or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

/// Returns the value stored by value_or_null().
template <class T> T value_of(const Json& json) { return json.is_null() ? T() : json.get<T>(); }

/// Returns an object with a label, its name, if it has one, and further values.
Json label_json(int label, const CGAL::Deformable_simplicial_complexes::Label_names& names,
                const Json& values);

/// Returns the statistics that all reports contain.
Json statistics_json(const Statistics& statistics);

/// Returns a change of connected components and its place. In the plane, the place has two
/// coordinates.
Json event_json(const DSC::Component_event& event, const std::array<double, 3>& where,
                int dimension, const CGAL::Deformable_simplicial_complexes::Label_names& names);

/// Replaces a file atomically, so that it is complete whenever the program ends.
/// \throws std::runtime_error if the file cannot be written
void write_json(const std::string& path, const Json& json);

} // namespace dsc

#endif // DSC_REPORT_JSON_H
