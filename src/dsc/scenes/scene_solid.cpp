// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenes/scene_solid.h"

#include <CGAL/Mesh_support/coordinates.h>

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

/// Checks that a solid has no fields except those of its type and those of all solids.
void require_known(const Json_fields& solid, std::vector<std::string> fields) {
  for (const char* field : {"type", "contact_angle", "sticks", "separates", "velocity",
                            "angular_velocity", "density", "fixed", "displacement", "rotation"})
    fields.push_back(field);
  solid.require_known(fields);
}

/// Sets the center of a tank, box or mesh to the given one or, without it, to the middle of its
/// box.
void set_center(const Json_fields& solid, Scene_solid& result) {
  for (std::size_t i = 0; i < 3; ++i)
    result.center[i] = (result.box[i] + result.box[i + 3]) / 2;
  result.has_given_center = solid.has("center");
  if (!result.has_given_center)
    return;
  solid.require_not_both("center", "density");
  result.center = solid.point("center");
}

/// Reads the fields of a solid that depend on its type.
void read_geometry(const Json_fields& solid, Scene_solid& result) {
  require_known(solid, {"point", "normal", "box", "open", "from", "to", "center", "radius", "axis",
                        "file", "part", "liquid"});
  using Kind = Scene_solid::Kind;
  const std::string type =
      solid.choice("type", {"plane", "tank", "box", "ball", "cylinder", "mesh"});
  if (solid.dimension() == 2 && (type == "cylinder" || type == "mesh"))
    solid.refuse("type", "the type '" + type +
                             "' exists only in space; use a plane, tank, box or "
                             "ball");
  if (type == "plane") {
    require_known(solid, {"point", "normal"});
    result.kind = Kind::plane;
    result.center = result.point = solid.point("point");
    result.direction = read_direction(solid, "normal");
  } else if (type == "tank") {
    require_known(solid, {"box", "open", "center"});
    result.kind = Kind::tank;
    result.box = solid.box("box");
    result.is_open = solid.flag("open", false);
    set_center(solid, result);
  } else if (type == "box") {
    require_known(solid, {"from", "to", "center"});
    result.kind = Kind::box;
    result.box = solid.corners();
    set_center(solid, result);
  } else if (type == "ball") {
    require_known(solid, {"center", "radius", "liquid"});
    result.kind = Kind::ball;
    result.center = result.point = solid.point("center");
    result.radius = solid.positive("radius");
    result.contains_liquid = read_side(solid);
  } else if (type == "cylinder") {
    require_known(solid, {"point", "axis", "radius", "liquid"});
    result.kind = Kind::cylinder;
    result.center = result.point = solid.point("point");
    result.direction = read_direction(solid, "axis");
    result.radius = solid.positive("radius");
    result.contains_liquid = read_side(solid);
  } else {
    require_known(solid, {"file", "part", "liquid", "center"});
    result.kind = Kind::mesh;
    result.file = solid.text("file");
    result.part = solid.text("part", "");
    set_center(solid, result);
    result.contains_liquid = read_side(solid);
  }
}

/// Reads the directions in which a body cannot move.
void read_fixed(const Json_fields& solid, Scene_solid& result) {
  static constexpr std::array<const char*, 3> axes = {"x", "y", "z"};
  const auto number = std::size_t(solid.dimension());
  const Json& names = solid.any("fixed");
  const auto refuse = [&] {
    solid.refuse("fixed", number == 2
                              ? R"(must be a list of some of "x", "y" and "rotation")"
                              : R"(must be a list of some of "x", "y", "z" and "rotation")");
  };
  if (!names.is_array())
    refuse();
  for (const Json& name : names) {
    const auto axis = std::find(axes.begin(), axes.begin() + number, name);
    if (axis == axes.begin() + number && name != "rotation")
      refuse();
    bool& is_fixed = name == "rotation" ? result.is_rotation_fixed
                                        : result.is_fixed[std::size_t(axis - axes.begin())];
    if (is_fixed)
      solid.refuse("fixed", "contains " + name.dump() + " twice; remove one of them");
    is_fixed = true;
  }
}

/// Reads the density of a body, and the directions in which it cannot move.
void read_body(const Json_fields& solid, Scene_solid& result) {
  if (!solid.has("density")) {
    if (solid.has("fixed"))
      solid.refuse("fixed", "has no effect without the field 'density'");
    return;
  }
  using Kind = Scene_solid::Kind;
  if (result.contains_liquid ||
      (result.kind != Kind::box && result.kind != Kind::ball && result.kind != Kind::mesh))
    solid.refuse("density", "applies only to a box, ball or mesh with liquids outside; remove it");
  result.density = solid.positive("density");
  if (solid.has("fixed"))
    read_fixed(solid, result);
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (result.is_fixed[axis] && result.velocity[axis] != 0)
      solid.refuse("velocity", "must be 0 in the directions of the field 'fixed'");
  if (result.is_rotation_fixed && result.angular_velocity != std::array<double, 3>())
    solid.refuse("angular_velocity", "must be 0 because the field 'fixed' contains 'rotation'");
}

/// Reads the expressions that move a solid.
void read_motion(const Json_fields& solid, Scene_solid& result) {
  for (const char* field : {"displacement", "rotation"})
    for (const char* other : {"density", "velocity", "angular_velocity"})
      solid.require_not_both(field, other);
  std::optional<Expression> displacement, rotation;
  if (solid.has("displacement"))
    displacement = solid.vector_in_time("displacement");
  const bool is_planar = solid.dimension() == 2;
  if (solid.has("rotation"))
    rotation = solid.expression("rotation", {"t"}, is_planar ? 1 : 3,
                                is_planar ? "an expression in t like '0.1*sin(t)'"
                                          : "three expressions in t like '0,0,0.1*sin(t)'");
  if (displacement || rotation)
    result.place = [displacement, rotation, is_planar](double t) {
      using Vector = Scene_solid::Place::Vector;
      Scene_solid::Place place;
      if (displacement) {
        const double* d = displacement->at({t});
        place.displacement = Vector(d[0], d[1], is_planar ? 0 : d[2]);
      }
      if (rotation) {
        const double* r = rotation->at({t});
        place.rotation = is_planar ? Vector(0, 0, r[0]) : Vector(r[0], r[1], r[2]);
      }
      return place;
    };
}

} // namespace

Scene_solid read_solid(const Json_fields& solid) {
  Scene_solid result;
  read_geometry(solid, result);
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
  read_body(solid, result);
  read_motion(solid, result);
  return result;
}

void Scene_solid::set_mesh(Mesh given) {
  mesh = std::make_shared<const Mesh>(std::move(given));
  if (has_given_center)
    return;
  Place::Vector sum(0, 0, 0);
  for (const auto v : mesh->vertices())
    sum = sum + (mesh->point(v) - CGAL::ORIGIN);
  center = DSC::coordinates_of<3>(sum / (std::max)(1., double(mesh->number_of_vertices())));
}

} // namespace dsc
