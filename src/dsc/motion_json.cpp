// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "motion_json.h"

#include "option_values.h"

#include <algorithm>
#include <array>

namespace dsc {
namespace {

Json json_of(const Rotation& rotation) {
  return {{"command", "rotate"}, {"axis", rotation.axis}, {"angle", rotation.degrees}};
}

Json json_of(const Offset& offset) {
  return {{"command", "offset"},
          {"distance", offset.distance.value},
          {"unit", offset.distance.in_mean_edges ? "mean interface edge" : "input"},
          {"move_faces", offset.moves_faces}};
}

Json json_of(const Advection& advection) {
  static const std::array<const char*, 3> commands = {"enright", "vortex", "advect"};
  const auto& schemes = integration_schemes();
  const auto scheme = std::find_if(schemes.begin(), schemes.end(), [&](const auto& named) {
    return named.second == advection.scheme;
  });
  return {{"command", commands[static_cast<std::size_t>(advection.field)]},
          {"velocity", value_or_null(advection.expressions)},
          {"period", value_or_null(advection.period)},
          {"dt", advection.dt},
          {"scheme", scheme->first}};
}

Json json_of(const Curvature_flow& flow) {
  return {{"command", "mean-curvature"},
          {"dt", value_or_null(flow.dt)},
          {"keep_volumes", flow.keeps_volumes}};
}

} // namespace

Json motion_json(const Motion& motion) {
  return std::visit([](const auto& m) { return json_of(m); }, motion);
}

} // namespace dsc
