// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluid_scene.h"

#include "errors.h"
#include "fluid_scenes.h"
#include "json_fields.h"

#include <CGAL/Deformable_simplicial_complexes/internal/text/files.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <utility>

namespace dsc {
namespace {

Fluid_shape read_shape(Json_fields& liquid, bool& is_surroundings) {
  static constexpr double most_amplitude = .5; // of radii
  Json_fields shape = liquid.object("shape");
  const std::string type = shape.text("type");
  Fluid_shape result;
  if (type == "ball") {
    Ball_shape ball;
    ball.center = shape.numbers<3>("center");
    ball.radius = shape.positive("radius");
    ball.mode = shape.count("mode", 0);
    ball.amplitude = shape.number("amplitude", 0);
    ball.triangles = shape.count("triangles", 0);
    static constexpr std::size_t highest = 100;
    if (!(std::abs(ball.amplitude) <= most_amplitude))
      shape.refuse("amplitude", "at most 0.5 is possible");
    if (ball.mode > highest)
      shape.refuse("mode", "at most 100 is possible");
    result = ball;
  } else if (type == "box") {
    const Box_shape box{shape.numbers<3>("from"), shape.numbers<3>("to")};
    for (std::size_t i = 0; i < 3; ++i)
      if (!(box.to[i] > box.from[i]))
        shape.refuse("to", "the box is empty");
    result = box;
  } else if (type == "cylinder") {
    Cylinder_shape column{shape.numbers<3>("from"), shape.numbers<3>("to"),
                          shape.positive("radius"), shape.number("amplitude", 0),
                          shape.number("wave_length", 0)};
    if (column.from == column.to)
      shape.refuse("to", "the cylinder has no length");
    if (!(std::abs(column.amplitude) <= most_amplitude))
      shape.refuse("amplitude", "at most 0.5 is possible");
    if (!(column.wave_length >= 0) || (column.amplitude != 0 && column.wave_length == 0))
      shape.refuse("wave_length", "a positive number is needed");
    result = column;
  } else if (type == "file") {
    File_shape file;
    file.file = shape.text("file");
    file.ball.center = shape.numbers<3>("center");
    file.ball.radius = shape.positive("radius");
    file.triangles = shape.count("triangles", 0);
    result = file;
  } else if (type == "pool") {
    Pool_shape pool;
    pool.level = shape.number("level");
    pool.height = shape.text("height", "");
    result = pool;
  } else if (type == "surroundings") {
    is_surroundings = true;
    result = Surroundings();
  } else {
    shape.refuse("type", "use ball, box, cylinder, file, pool or surroundings");
  }
  shape.close();
  return result;
}

/// A vector of three numbers, or three expressions.
std::string read_velocity(Json_fields& liquid) {
  if (!liquid.has("velocity"))
    return "0,0,0";
  if (liquid.any("velocity").is_string())
    return liquid.text("velocity");
  std::string result;
  for (double v : liquid.numbers<3>("velocity"))
    result += (result.empty() ? "" : ",") + Json(v).dump();
  return result;
}

/// Where a liquid or gas is, and its label.
template <class Filling> void read_filling(Json_fields& json, std::size_t index, Filling& filling) {
  bool is_surroundings = false;
  filling.shape = read_shape(json, is_surroundings);
  filling.label = is_surroundings ? 0 : int(json.count("label", index + 1));
  if (!is_surroundings && filling.label == 0)
    json.refuse("label", "0 is what is around all others: use the shape surroundings");
}

Scene_liquid read_liquid(Json_fields liquid, std::size_t index) {
  Scene_liquid result;
  read_filling(liquid, index, result);
  result.density = liquid.positive("density");
  result.viscosity = liquid.number("viscosity", 0);
  if (result.viscosity < 0)
    liquid.refuse("viscosity", "0 or more is needed");
  result.velocity = read_velocity(liquid);
  liquid.close();
  return result;
}

Scene_gas read_gas(Json_fields gas, std::size_t index) {
  Scene_gas result;
  read_filling(gas, index, result);
  result.pressure = gas.number("pressure");
  if (result.pressure < 0)
    gas.refuse("pressure", "0 or more is needed");
  result.exponent = gas.number("exponent", 1.4);
  if (result.exponent < 0)
    gas.refuse("exponent", "0 or more is needed");
  gas.close();
  return result;
}

Scene_source read_source(Json_fields source) {
  const Scene_source result = {source.numbers<3>("center"), source.positive("radius"),
                               source.number("rate")};
  source.close();
  return result;
}

bool read_side(Json_fields& solid) {
  const std::string liquid = solid.text("liquid", "outside");
  if (liquid != "inside" && liquid != "outside")
    solid.refuse("liquid", "use inside or outside");
  return liquid == "inside";
}

Scene_solid read_solid(Json_fields solid) {
  Scene_solid result;
  using Kind = Scene_solid::Kind;
  const std::string type = solid.text("type");
  if (type == "plane") {
    result.kind = Kind::plane;
    result.point = solid.numbers<3>("point");
    result.direction = solid.numbers<3>("normal");
  } else if (type == "tank") {
    result.kind = Kind::tank;
    result.box = solid.numbers<6>("box");
    result.is_open = solid.flag("open", false);
  } else if (type == "ball") {
    result.kind = Kind::ball;
    result.point = solid.numbers<3>("center");
    result.radius = solid.positive("radius");
    result.contains_liquid = read_side(solid);
  } else if (type == "cylinder") {
    result.kind = Kind::cylinder;
    result.point = solid.numbers<3>("point");
    result.direction = solid.numbers<3>("axis");
    result.radius = solid.positive("radius");
    result.contains_liquid = read_side(solid);
  } else if (type == "mesh") {
    result.kind = Kind::mesh;
    result.file = solid.text("file");
    result.contains_liquid = read_side(solid);
  } else {
    solid.refuse("type", "use plane, tank, ball, cylinder or mesh");
  }
  result.contact_angle = solid.number("contact_angle", 90);
  if (!(result.contact_angle >= 0 && result.contact_angle <= 180))
    solid.refuse("contact_angle", "0 to 180 degrees are possible");
  result.sticks = solid.flag("sticks", false);
  result.separates = solid.flag("separates", true);
  if (solid.has("velocity"))
    result.velocity = solid.numbers<3>("velocity");
  if (solid.has("angular_velocity"))
    result.angular_velocity = solid.numbers<3>("angular_velocity");
  solid.close();
  return result;
}

std::vector<Fluid_scene::Tension> read_tensions(Json_fields& scene) {
  if (!scene.has("surface_tension"))
    return {};
  if (scene.any("surface_tension").is_number())
    return {{{0, 1}, scene.number("surface_tension")}};
  std::vector<Fluid_scene::Tension> result;
  for (Json_fields tension : scene.objects("surface_tension")) {
    const auto labels = tension.numbers<2>("labels");
    for (double label : labels)
      if (label != std::floor(label) || !(std::abs(label) <= std::numeric_limits<int>::max()))
        tension.refuse("labels", "whole numbers are needed");
    result.push_back({{int(labels[0]), int(labels[1])}, tension.number("value")});
    tension.close();
  }
  return result;
}

Scene_probe read_probe(Json_fields probe) {
  Scene_probe result;
  result.name = probe.text("name");
  if (probe.has("mode")) {
    result.mode = probe.count("mode", 0);
    result.center = probe.numbers<3>("center");
  } else {
    result.place = probe.numbers<2>("height_at");
  }
  probe.close();
  return result;
}

} // namespace

Fluid_scene read_scene(const Json& json) {
  Json_fields scene(json, "the scene");
  Fluid_scene result;
  result.json = json;
  result.title = scene.text("title", "");
  result.domain = scene.numbers<6>("domain");
  for (std::size_t i = 0; i < 3; ++i)
    if (!(result.domain[i + 3] > result.domain[i]))
      scene.refuse("domain", "three least coordinates and three larger ones are needed");
  result.edge = scene.positive("edge");
  std::size_t index = 0;
  for (Json_fields& liquid : scene.objects("liquids"))
    result.liquids.push_back(read_liquid(liquid, index++));
  if (result.liquids.empty())
    scene.refuse("liquids", "one at least is needed");
  for (const Scene_liquid& a : result.liquids)
    for (const Scene_liquid& b : result.liquids)
      if (a.label == b.label && (a.density != b.density || a.viscosity != b.viscosity))
        scene.refuse("liquids",
                     "those of one label are one liquid, with one density and viscosity");
  for (Json_fields& gas : scene.objects("gases"))
    result.gases.push_back(read_gas(gas, index++));
  for (const Scene_gas& gas : result.gases) {
    for (const Scene_liquid& liquid : result.liquids)
      if (gas.label == liquid.label)
        scene.refuse("gases", "a label is a liquid or a gas");
    for (const Scene_gas& other : result.gases)
      if (gas.label == other.label &&
          (gas.pressure != other.pressure || gas.exponent != other.exponent))
        scene.refuse("gases", "those of one label are one gas, with one pressure and exponent");
  }
  for (const Json_fields& source : scene.objects("sources"))
    result.sources.push_back(read_source(source));
  result.tensions = read_tensions(scene);
  for (const auto& tension : result.tensions)
    if (tension.value < 0)
      scene.refuse("surface_tension", "0 or more is needed");
  if (scene.has("gravity"))
    result.gravity = scene.numbers<3>("gravity");
  for (const Json_fields& solid : scene.objects("solids"))
    result.solids.push_back(read_solid(solid));
  for (const Json_fields& probe : scene.objects("probes"))
    result.probes.push_back(read_probe(probe));
  result.time_step = scene.positive("time_step");
  result.cfl = scene.number("cfl", 0);
  if (result.cfl < 0)
    scene.refuse("cfl", "0 or more is needed");
  result.end = scene.positive("end");
  result.implicitness = scene.number("implicitness", .5);
  if (!(result.implicitness >= .5 && result.implicitness <= 1))
    scene.refuse("implicitness", "0.5 to 1 is possible");
  result.interface_tolerance = scene.number("interface_tolerance", .04);
  if (result.interface_tolerance < 0)
    scene.refuse("interface_tolerance", "0 or more is needed");
  result.adaptation_interval = scene.count("adaptation_interval", 4);
  result.relaxation_step = 0;
  result.relaxation_steps = 0;
  if (scene.has("relaxation")) {
    Json_fields relaxation = scene.object("relaxation");
    result.relaxation_step = relaxation.positive("time_step");
    result.relaxation_steps = relaxation.count("steps", 100);
    relaxation.close();
  } else {
    scene.text("relaxation", ""); // a known field
  }
  scene.close();
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
  std::string text;
  for (const Named_scene& scene : named_scenes())
    if (scene.name == name)
      text = scene.json;
  if (text.empty()) {
    std::ifstream in(name, std::ios::binary);
    if (!in)
      throw Input_error("there is no file and no scene '" + name +
                        "'; dsc fluid --list names all scenes");
    text.assign(std::istreambuf_iterator<char>(in), {});
  }
  try {
    return read_scene(Json::parse(text));
  } catch (const Json::exception& error) {
    throw Input_error(name + " cannot be read as JSON: " + error.what());
  }
}

std::vector<std::array<std::string, 2>> scene_names() {
  std::vector<std::array<std::string, 2>> result;
  for (const Named_scene& scene : named_scenes())
    result.push_back({scene.name, Json::parse(scene.json).at("title").get<std::string>()});
  return result;
}

} // namespace dsc
