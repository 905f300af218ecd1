// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluid_scene.h"

#include "errors.h"
#include "fluid_scene_checks.h"
#include "json_fields.h"
#include "json_text.h"
#include "nearest_name.h"
#include "scene_files.h"

#include <CGAL/Deformable_simplicial_complexes/internal/text/files.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <utility>

namespace dsc {
namespace {

constexpr double most_amplitude = .5; // in radii
constexpr std::size_t highest_mode = 100;

double read_amplitude(const Json_fields& shape) {
  const double result = shape.number("amplitude", 0);
  if (!(std::abs(result) <= most_amplitude))
    shape.refuse("amplitude", "must be from -0.5 to 0.5");
  return result;
}

std::size_t read_mode(const Json_fields& json) {
  const std::size_t result = json.count("mode", 0);
  if (result > highest_mode)
    json.refuse("mode", "must be at most 100");
  return result;
}

/// Throws if only one of two fields is given that have an effect only together.
void require_both_or_none(const Json_fields& shape, const char* a, const char* b) {
  if (shape.has(a) != shape.has(b)) {
    const bool has_a = shape.has(a);
    shape.refuse(has_a ? a : b,
                 std::string("has no effect without the field '") + (has_a ? b : a) + "'");
  }
}

Ball_shape read_ball(const Json_fields& shape) {
  shape.require_known({"type", "center", "radius", "mode", "amplitude", "triangles"});
  require_both_or_none(shape, "mode", "amplitude");
  return {shape.numbers<3>("center"), shape.positive("radius"), read_mode(shape),
          read_amplitude(shape), shape.count("triangles", 0)};
}

Box_shape read_box(const Json_fields& shape) {
  shape.require_known({"type", "from", "to"});
  const Box_shape box{shape.numbers<3>("from"), shape.numbers<3>("to")};
  for (std::size_t i = 0; i < 3; ++i)
    if (!(box.to[i] > box.from[i]))
      shape.refuse("to", "must be larger than 'from' in each coordinate: the box is empty");
  return box;
}

Cylinder_shape read_cylinder(const Json_fields& shape) {
  shape.require_known({"type", "from", "to", "radius", "amplitude", "wave_length"});
  require_both_or_none(shape, "amplitude", "wave_length");
  const Cylinder_shape column{shape.numbers<3>("from"), shape.numbers<3>("to"),
                              shape.positive("radius"), read_amplitude(shape),
                              shape.has("wave_length") ? shape.positive("wave_length") : 0};
  if (column.from == column.to)
    shape.refuse("to", "must differ from 'from': the cylinder has no length");
  return column;
}

File_shape read_file(const Json_fields& shape) {
  shape.require_known({"type", "file", "center", "radius", "triangles"});
  return {shape.text("file"),
          {shape.numbers<3>("center"), shape.positive("radius")},
          shape.count("triangles", 0)};
}

Pool_shape read_pool(const Json_fields& shape) {
  shape.require_known({"type", "level", "height"});
  Pool_shape result{shape.number("level"), {}};
  if (shape.has("height"))
    result.height =
        shape.expression("height", {"x", "y"}, 1, "an expression in x and y like '1+0.1*cos(x)'");
  return result;
}

Fluid_shape read_shape(const Json_fields& shape) {
  shape.require_known({"type", "center", "radius", "mode", "amplitude", "triangles", "from", "to",
                       "wave_length", "file", "level", "height"}); // "type" may be misspelt
  const std::string type =
      shape.choice("type", {"ball", "box", "cylinder", "file", "pool", "surroundings"});
  if (type == "ball")
    return read_ball(shape);
  if (type == "box")
    return read_box(shape);
  if (type == "cylinder")
    return read_cylinder(shape);
  if (type == "file")
    return read_file(shape);
  if (type == "pool")
    return read_pool(shape);
  shape.require_known({"type"});
  return Surroundings();
}

/// Reads a vector of three numbers, or three expressions.
std::optional<Expression> read_velocity(const Json_fields& liquid) {
  static const std::string form = "three expressions in x, y and z like '-y,x,0'";
  static const std::vector<std::string> variables = {"x", "y", "z"};
  if (!liquid.has("velocity"))
    return std::nullopt;
  if (liquid.any("velocity").is_string())
    return liquid.expression("velocity", variables, 3, form);
  std::string text;
  for (double v : liquid.numbers<3>("velocity"))
    text += (text.empty() ? "" : ",") + Json(v).dump();
  return Expression(text, variables, "velocity of " + liquid.name(), form);
}

/// Reads the shape of a liquid or gas, and its label.
template <class Filling>
void read_filling(const Json_fields& json, std::size_t index, Filling& filling) {
  filling.shape = read_shape(json.object("shape"));
  const bool is_surroundings = std::holds_alternative<Surroundings>(filling.shape);
  if (is_surroundings && json.has("label"))
    json.refuse("label", "the shape 'surroundings' has label 0; remove the field");
  filling.label = is_surroundings ? 0 : int(json.count("label", index + 1));
  if (!is_surroundings && filling.label == 0)
    json.refuse("label", "label 0 is reserved for the shape 'surroundings'; choose another label");
}

Scene_liquid read_liquid(const Json_fields& liquid, std::size_t index) {
  liquid.require_known({"shape", "label", "density", "viscosity", "velocity"});
  Scene_liquid result;
  read_filling(liquid, index, result);
  result.density = liquid.positive("density");
  result.viscosity = liquid.not_negative("viscosity", 0);
  result.velocity = read_velocity(liquid);
  return result;
}

Scene_gas read_gas(const Json_fields& gas, std::size_t index) {
  gas.require_known({"shape", "label", "pressure", "exponent"});
  Scene_gas result;
  read_filling(gas, index, result);
  gas.any("pressure");
  result.pressure = gas.not_negative("pressure", 0);
  result.exponent = gas.not_negative("exponent", 1.4);
  return result;
}

Scene_source read_source(const Json_fields& source) {
  source.require_known({"center", "radius", "rate"});
  const Scene_source result = {source.numbers<3>("center"), source.positive("radius"),
                               source.number("rate")};
  if (result.rate == 0)
    source.refuse("rate", "must not be 0: the source has no effect; remove the source");
  return result;
}

bool read_side(const Json_fields& solid) {
  return solid.has("liquid") && solid.choice("liquid", {"inside", "outside"}) == "inside";
}

std::array<double, 3> read_direction(const Json_fields& solid, const char* field) {
  const std::array<double, 3> result = solid.numbers<3>(field);
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
  require_known({"point", "normal", "box", "open", "center", "radius", "axis", "file", "liquid"});
  using Kind = Scene_solid::Kind;
  const std::string type = solid.choice("type", {"plane", "tank", "ball", "cylinder", "mesh"});
  if (type == "plane") {
    require_known({"point", "normal"});
    result.kind = Kind::plane;
    result.point = solid.numbers<3>("point");
    result.direction = read_direction(solid, "normal");
  } else if (type == "tank") {
    require_known({"box", "open"});
    result.kind = Kind::tank;
    result.box = solid.numbers<6>("box");
    result.is_open = solid.flag("open", false);
  } else if (type == "ball") {
    require_known({"center", "radius", "liquid"});
    result.kind = Kind::ball;
    result.point = solid.numbers<3>("center");
    result.radius = solid.positive("radius");
    result.contains_liquid = read_side(solid);
  } else if (type == "cylinder") {
    require_known({"point", "axis", "radius", "liquid"});
    result.kind = Kind::cylinder;
    result.point = solid.numbers<3>("point");
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

Scene_solid read_solid(const Json_fields& solid) {
  Scene_solid result;
  read_body(solid, result);
  result.contact_angle = solid.number("contact_angle", 90);
  if (!(result.contact_angle >= 0 && result.contact_angle <= 180))
    solid.refuse("contact_angle", "must be from 0 to 180 degrees");
  result.sticks = solid.flag("sticks", false);
  result.separates = solid.flag("separates", true);
  if (solid.has("velocity"))
    result.velocity = solid.numbers<3>("velocity");
  if (solid.has("angular_velocity"))
    result.angular_velocity = solid.numbers<3>("angular_velocity");
  return result;
}

std::vector<Fluid_scene::Tension> read_tensions(const Json_fields& scene) {
  if (!scene.has("surface_tension"))
    return {};
  if (scene.any("surface_tension").is_number())
    return {{{0, 1}, scene.not_negative("surface_tension", 0)}};
  std::vector<Fluid_scene::Tension> result;
  for (const Json_fields& tension : scene.objects("surface_tension")) {
    tension.require_known({"labels", "value"});
    const auto labels = tension.numbers<2>("labels");
    for (double label : labels)
      if (label != std::floor(label) || !(std::abs(label) <= std::numeric_limits<int>::max()))
        tension.refuse("labels", "must be integers");
    tension.any("value");
    result.push_back({{int(labels[0]), int(labels[1])}, tension.not_negative("value", 0)});
  }
  return result;
}

void read_sides(const Json_fields& sides, Fluid_scene& scene) {
  sides.require_known({names_of_sides.begin(), names_of_sides.end()});
  for (std::size_t side = 0; side < names_of_sides.size(); ++side)
    if (sides.has(names_of_sides[side])) {
      const auto velocity = sides.numbers<3>(names_of_sides[side]);
      if (velocity[side / 2] != 0)
        sides.refuse(names_of_sides[side], "must be a velocity along the side");
      scene.sides[side] = velocity;
    }
}

Scene_probe read_probe(const Json_fields& probe) {
  const bool has_mode = probe.has("mode");
  if (has_mode && probe.has("height_at"))
    probe.refuse("height_at", "a probe measures either a mode or a height; write two probes");
  if (has_mode)
    probe.require_known({"name", "mode", "center"});
  else
    probe.require_known({"name", "height_at", "mode", "center"});
  Scene_probe result;
  result.name = probe.text("name");
  if (has_mode) {
    result.mode = read_mode(probe);
    result.center = probe.numbers<3>("center");
  } else {
    if (probe.has("center"))
      probe.refuse("center", "has no effect without the field 'mode'");
    result.place = probe.numbers<2>("height_at");
  }
  return result;
}

void read_relaxation(const Json_fields& scene, Fluid_scene& result) {
  result.relaxation_step = 0;
  result.relaxation_steps = 0;
  if (!scene.has("relaxation"))
    return;
  const Json_fields relaxation = scene.object("relaxation");
  relaxation.require_known({"time_step", "steps"});
  result.relaxation_step = relaxation.positive("time_step");
  result.relaxation_steps = relaxation.count("steps", 100);
  if (result.relaxation_steps == 0)
    relaxation.refuse("steps", "must not be 0: the relaxation has no effect; remove it");
}

} // namespace

Fluid_scene read_scene(const Json& json) {
  const Json_fields scene(json, "the scene");
  scene.require_known({"title", "domain", "edge", "liquids", "gases", "sources", "surface_tension",
                       "gravity", "solids", "sides", "probes", "time_step", "cfl", "end",
                       "implicitness", "interface_tolerance", "adaptation_interval", "relaxation"});
  Fluid_scene result;
  result.json = json;
  result.title = scene.text("title", "");
  result.domain = scene.numbers<6>("domain");
  for (std::size_t i = 0; i < 3; ++i)
    if (!(result.domain[i + 3] > result.domain[i]))
      scene.refuse("domain",
                   "must be three minimum coordinates and three larger maximum coordinates");
  result.edge = scene.positive("edge");
  std::size_t index = 0;
  for (const Json_fields& liquid : scene.objects("liquids"))
    result.liquids.push_back(read_liquid(liquid, index++));
  if (result.liquids.empty())
    scene.refuse("liquids", "must contain at least one liquid");
  for (const Json_fields& gas : scene.objects("gases"))
    result.gases.push_back(read_gas(gas, index++));
  for (const Json_fields& source : scene.objects("sources"))
    result.sources.push_back(read_source(source));
  result.tensions = read_tensions(scene);
  if (scene.has("gravity"))
    result.gravity = scene.numbers<3>("gravity");
  for (const Json_fields& solid : scene.objects("solids"))
    result.solids.push_back(read_solid(solid));
  if (scene.has("sides"))
    read_sides(scene.object("sides"), result);
  for (const Json_fields& probe : scene.objects("probes"))
    result.probes.push_back(read_probe(probe));
  result.time_step = scene.positive("time_step");
  result.cfl = scene.not_negative("cfl", 0);
  result.end = scene.positive("end");
  result.implicitness = scene.number("implicitness", .5);
  if (!(result.implicitness >= .5 && result.implicitness <= 1))
    scene.refuse("implicitness", "must be from 0.5 to 1");
  result.interface_tolerance = scene.not_negative("interface_tolerance", .04);
  result.adaptation_interval = scene.count("adaptation_interval", 4);
  read_relaxation(scene, result);
  require_consistent(result, scene);
  return result;
}

std::vector<std::pair<int, const Fluid_shape*>> shapes_of(const Fluid_scene& scene) {
  std::vector<std::pair<int, const Fluid_shape*>> result;
  for (const Scene_liquid& liquid : scene.liquids)
    result.emplace_back(liquid.label, &liquid.shape);
  for (const Scene_gas& gas : scene.gases)
    result.emplace_back(gas.label, &gas.shape);
  return result;
}

Fluid_scene find_scene(const std::string& name) {
  const std::map<std::string, std::string> scenes = scene_files();
  const auto found = scenes.find(name);
  if (found == scenes.end() && !std::filesystem::exists(name)) {
    std::vector<std::string> names;
    for (const auto& scene : scenes)
      names.push_back(scene.first);
    throw Input_error("there is no file or scene '" + name + "'" +
                      (scenes.empty() ? "; no scenes were found in " + searched_scene_folders()
                                      : advice_on_name(name, names, "scenes")));
  }
  const std::string& path = found == scenes.end() ? name : found->second;
  return read_scene(
      parse_json(CGAL::Deformable_simplicial_complexes::internal::file_contents(path), name));
}

std::vector<std::array<std::string, 2>> scene_names() {
  const std::map<std::string, std::string> scenes = scene_files();
  if (scenes.empty())
    throw Input_error("no scenes were found in " + searched_scene_folders() +
                      "; install the program again");
  std::vector<std::array<std::string, 2>> result;
  for (const auto& [name, path] : scenes) {
    const Json json =
        parse_json(CGAL::Deformable_simplicial_complexes::internal::file_contents(path), path);
    result.push_back({name, json.value("title", "")});
  }
  return result;
}

} // namespace dsc
