// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluid_scene_parts.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace dsc {
namespace {

bool read_side(const Json_fields& solid) {
  return solid.has("liquid") && solid.choice("liquid", {"inside", "outside"}) == "inside";
}

std::array<double, 3> read_direction(const Json_fields& solid, const char* field) {
  const std::array<double, 3> result = solid.point(field);
  if (result == std::array<double, 3>())
    solid.refuse(field, "must not be the zero vector");
  return result;
}

/// Reads the fields of a solid that depend on its type.
void read_body(const Json_fields& solid, Scene_solid& result) {
  const auto require_known = [&](std::vector<std::string> fields) {
    for (const char* field :
         {"type", "contact_angle", "sticks", "separates", "velocity", "angular_velocity"})
      fields.push_back(field);
    solid.require_known(fields);
  };
  require_known({"point", "normal", "box", "open", "from", "to", "center", "radius", "axis", "file",
                 "liquid"});
  using Kind = Scene_solid::Kind;
  const std::string type =
      solid.choice("type", {"plane", "tank", "box", "ball", "cylinder", "mesh"});
  if (solid.dimension() == 2 && (type == "cylinder" || type == "mesh"))
    solid.refuse("type", "the type '" + type +
                             "' exists only in space; use a plane, tank, box or "
                             "ball");
  if (type == "plane") {
    require_known({"point", "normal"});
    result.kind = Kind::plane;
    result.point = solid.point("point");
    result.direction = read_direction(solid, "normal");
  } else if (type == "tank") {
    require_known({"box", "open"});
    result.kind = Kind::tank;
    result.box = solid.box("box");
    result.is_open = solid.flag("open", false);
  } else if (type == "box") {
    require_known({"from", "to"});
    result.kind = Kind::box;
    const Box_shape box = read_corners(solid);
    for (std::size_t i = 0; i < 3; ++i) {
      result.box[i] = box.from[i];
      result.box[i + 3] = box.to[i];
    }
  } else if (type == "ball") {
    require_known({"center", "radius", "liquid"});
    result.kind = Kind::ball;
    result.point = solid.point("center");
    result.radius = solid.positive("radius");
    result.contains_liquid = read_side(solid);
  } else if (type == "cylinder") {
    require_known({"point", "axis", "radius", "liquid"});
    result.kind = Kind::cylinder;
    result.point = solid.point("point");
    result.direction = read_direction(solid, "axis");
    result.radius = solid.positive("radius");
    result.contains_liquid = read_side(solid);
  } else {
    require_known({"file", "liquid"});
    result.kind = Kind::mesh;
    result.file = solid.text("file");
    result.contains_liquid = read_side(solid);
  }
}

} // namespace

Scene_solid read_solid(const Json_fields& solid) {
  Scene_solid result;
  read_body(solid, result);
  result.contact_angle = solid.number("contact_angle", 90);
  if (!(result.contact_angle >= 0 && result.contact_angle <= 180))
    solid.refuse("contact_angle", "must be from 0 to 180 degrees");
  result.sticks = solid.flag("sticks", false);
  result.separates = solid.flag("separates", true);
  if (solid.has("velocity"))
    result.velocity = solid.point("velocity");
  if (solid.has("angular_velocity") && solid.dimension() == 2)
    result.angular_velocity = {0, 0, solid.number("angular_velocity")};
  else if (solid.has("angular_velocity"))
    result.angular_velocity = solid.point("angular_velocity");
  return result;
}

} // namespace dsc
