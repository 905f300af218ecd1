// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "motions/saved_arrays.h"

#include "output/report_json.h"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace dsc {
namespace {

using CGAL::Deformable_simplicial_complexes::Mesh_array;
using CGAL::Deformable_simplicial_complexes::Mesh_arrays;

Json json_of(const Mesh_array& array) {
  return {{"name", array.name},
          {"type", array.type},
          {"components", array.components},
          {"values", array.values}};
}

Mesh_array array_of(const Json& json) {
  return {json.at("name"), json.at("type"), json.at("components"),
          json.at("values").get<std::vector<double>>()};
}

} // namespace

std::string with_arrays(const std::string& metadata, const Mesh_arrays& arrays) {
  const bool has_usual_name = arrays.labels.name.empty() || arrays.labels.name == "label";
  if (arrays.points.empty() && arrays.cells.empty() && has_usual_name)
    return metadata;
  Json json = {
      {"labels", json_of(arrays.labels)}, {"points", Json::array()}, {"cells", Json::array()}};
  for (const Mesh_array& array : arrays.points)
    json["points"].push_back(json_of(array));
  for (const Mesh_array& array : arrays.cells)
    json["cells"].push_back(json_of(array));
  std::string result = metadata + '\n';
  Json::to_cbor(json, result); // exact, and contains numbers that are not finite
  return result;
}

Mesh_arrays take_arrays(std::string& metadata) {
  Mesh_arrays result;
  const std::size_t end = metadata.find('\n');
  if (end == std::string::npos)
    return result;
  try {
    const Json json = Json::from_cbor(metadata.begin() + std::ptrdiff_t(end) + 1, metadata.end());
    result.labels = array_of(json.at("labels"));
    for (const Json& array : json.at("points"))
      result.points.push_back(array_of(array));
    for (const Json& array : json.at("cells"))
      result.cells.push_back(array_of(array));
    metadata.erase(end);
    return result;
  } catch (const Json::exception&) { // metadata of another program
    return Mesh_arrays();
  }
}

} // namespace dsc
