// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "motions/motion_json.h"

#include "programs/option_values.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>

namespace dsc {
namespace {

const std::array<const char*, 3> commands_of_fields = {"enright", "vortex", "advect"};

Json json_of(const Rotation& rotation) {
  return {{"command", "rotate"}, {"axis", rotation.axis}, {"angle", rotation.degrees}};
}

// Returns the name of an option's value.
template <class Value>
std::string name_of(const std::map<std::string, Value>& names, const Value& value) {
  return std::find_if(names.begin(), names.end(),
                      [&](const auto& named) { return named.second == value; })
      ->first;
}

const char* const mean_edge = "mean interface edge";

Json json_of(const Offset& offset) {
  return {{"command", "offset"},
          {"distance", offset.distance.value},
          {"unit", offset.distance.in_mean_edges ? mean_edge : "input"},
          {"move_faces", offset.moves_faces},
          {"corners", name_of(corner_rules(), offset.corners)}};
}

Json json_of(const Advection& advection) {
  return {{"command", commands_of_fields[static_cast<std::size_t>(advection.field)]},
          {"velocity", value_or_null(advection.expressions)},
          {"period", value_or_null(advection.period)},
          {"dt", advection.dt},
          {"scheme", name_of(integration_schemes(), advection.scheme)},
          {"tolerance", advection.tolerance ? Json(*advection.tolerance) : Json()}};
}

Json json_of(const Curvature_flow& flow) {
  Json result = {{"command", "mean-curvature"},
                 {"dt", value_or_null(flow.dt)},
                 {"keep_volumes", flow.keeps_volumes},
                 {"tolerance", flow.tolerance ? Json(*flow.tolerance) : Json()}};
  for (const auto& [label, volume] : flow.volumes)
    result["volumes"].push_back({{"label", label}, {"volume", volume}});
  return result;
}

Json json_of(const Zalesak& zalesak) { return {{"command", "zalesak"}, {"dt", zalesak.dt}}; }

// Checkpoints of older versions may have no tolerance.
std::optional<double> tolerance_of(const Json& json) {
  const auto found = json.find("tolerance");
  return found == json.end() || found->is_null() ? std::nullopt
                                                 : std::make_optional(found->get<double>());
}

// Older checkpoints have no volumes.
std::map<int, double> volumes_of(const Json& json) {
  std::map<int, double> result;
  if (json.contains("volumes"))
    for (const Json& entry : json.at("volumes"))
      result.emplace(entry.at("label"), entry.at("volume"));
  return result;
}

} // namespace

Json motion_json(const Motion& motion) {
  return std::visit([](const auto& m) { return json_of(m); }, motion);
}

Motion motion_from_json(const Json& json) {
  const std::string command = json.at("command");
  if (command == "rotate")
    return Rotation{json.at("axis"), json.at("angle")};
  if (command == "offset")
    return Offset{{json.at("distance"), json.at("unit") == mean_edge},
                  json.at("move_faces"),
                  corner_rules().at(json.value("corners", "miter"))};
  if (command == "mean-curvature")
    return Curvature_flow{value_of<double>(json.at("dt")), json.at("keep_volumes"),
                          tolerance_of(json), volumes_of(json)};
  if (command == "zalesak")
    return Zalesak{json.at("dt")};
  const auto field = std::find(commands_of_fields.begin(), commands_of_fields.end(), command);
  if (field == commands_of_fields.end())
    throw std::out_of_range("unknown command " + command);
  return Advection{static_cast<Advection::Field>(field - commands_of_fields.begin()),
                   value_of<std::string>(json.at("velocity")),
                   value_of<double>(json.at("period")),
                   json.at("dt"),
                   integration_schemes().at(json.at("scheme")),
                   tolerance_of(json)};
}

} // namespace dsc
