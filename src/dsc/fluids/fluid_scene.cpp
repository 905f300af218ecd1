// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluids/fluid_scene.h"

#include "fluids/fluid_scene_parts.h"
#include "input/files.h"
#include "input/nearest_name.h"
#include "input/translations.h"
#include "programs/errors.h"
#include "scenes/json_fields.h"

#include <CGAL/Mesh_files/internal/text/files.h>

#include <set>

namespace dsc {
namespace {

/// A parser callback that detects duplicate fields in objects and lists.
class Field_names
{
public:
  explicit Field_names(const std::string& file) : m_file(file) {}

  void pass(Json::parse_event_t event, const Json& json) {
    using Event = Json::parse_event_t;
    switch (event) {
    case Event::object_start:
    case Event::array_start:
      m_levels.push_back({event == Event::array_start, 0, "", {}});
      break;
    case Event::object_end:
    case Event::array_end:
      m_levels.pop_back();
      pass_element();
      break;
    case Event::value:
      pass_element();
      break;
    case Event::key:
      Level& level = m_levels.back();
      level.field = json.get<std::string>();
      if (!level.fields.insert(level.field).second)
        throw Input_error(m_file + ": the field '" + place() +
                          "' occurs twice; remove one of them");
    }
  }

private:
  struct Level
  {
    bool is_list;
    std::size_t index;
    std::string field;
    std::set<std::string> fields;
  };

  void pass_element() {
    if (!m_levels.empty())
      ++m_levels.back().index;
  }

  /// Returns the place of the field read last, like "liquids[0].density".
  std::string place() const {
    std::string result;
    for (const Level& level : m_levels)
      result += level.is_list ? "[" + std::to_string(level.index) + "]"
                              : (result.empty() ? "" : ".") + level.field;
    return result;
  }

  std::string m_file;
  std::vector<Level> m_levels;
};

/// Returns the message of the library, without its error number.
std::string reason(const Json::exception& error) {
  const std::string text = error.what();
  const std::size_t bracket = text.find("] ");
  std::string result = bracket == std::string::npos ? text : text.substr(bracket + 2);
  if (text.find("/'") != std::string::npos)
    result += "; JSON has no comments";
  return result;
}

/// Parses JSON written by users.
/// \param name name of the file, for messages
/// \throws Input_error if the text is not JSON, or an object has two fields of the same name
Json parse_json(const std::string& text, const std::string& name) {
  Field_names names(name);
  try {
    return Json::parse(text, [&](int, Json::parse_event_t event, const Json& json) {
      names.pass(event, json);
      return true;
    });
  } catch (const Json::exception& error) {
    throw Input_error(name + " is not valid JSON: " + reason(error));
  }
}

/// Reads a vector of numbers, or expressions for its coordinates.
std::optional<Expression> read_velocity(const Json_fields& liquid) {
  const bool is_planar = liquid.dimension() == 2;
  const std::string form = is_planar ? "two expressions in x and y like '-y,x'"
                                     : "three expressions in x, y and z like '-y,x,0'";
  const std::vector<std::string> variables = liquid.coordinate_names();
  if (!liquid.has("velocity"))
    return std::nullopt;
  if (liquid.any("velocity").is_string())
    return liquid.expression("velocity", variables, liquid.dimension(), form);
  const auto velocity = liquid.point("velocity");
  std::string text;
  for (std::size_t i = 0; i < variables.size(); ++i)
    text += (text.empty() ? "" : ",") + Json(velocity[i]).dump();
  return Expression(text, variables, "velocity of " + liquid.name(), form);
}

/// The labels of the liquids and gases of a scene.
struct Filling_labels
{
  Label_names& names;
  std::set<int> numbers; ///< labels that are not given by names

  Filling_labels(const Json_fields& scene, Label_names& names) : names(names) {
    int index = 0;
    for (const char* const kind : {"liquids", "gases"})
      for (const Json_fields& filling : scene.objects(kind)) {
        ++index;
        if (!filling.has("label"))
          numbers.insert(index);
        else if (const Json& label = filling.any("label"); label.is_number_integer())
          numbers.insert(label.get<int>());
      }
  }
};

/// Returns the label of a name: that of an earlier liquid or gas with this name, or a new one.
int label_of_name(const Json_fields& json, int new_label, Filling_labels& labels) {
  Label_names& names = labels.names;
  const std::string name = json.text("label");
  if (name.empty() || name.find_first_of("\n\r\t\x1b") != std::string::npos)
    json.refuse("label", "must be a number or a name in one line");
  while (labels.numbers.count(new_label) > 0 || names.count(new_label) > 0)
    ++new_label;
  const int label = label_with_name(name, names).value_or(new_label);
  names.emplace(label, name);
  return label;
}

/// Reads the shape of a liquid or gas, and its label.
template <class Filling>
void read_filling(const Json_fields& json, std::size_t index, Filling_labels& labels,
                  Filling& filling) {
  filling.shape = read_shape(json.object("shape"));
  const bool is_surroundings = std::holds_alternative<Surroundings>(filling.shape);
  const bool has_name = json.has("label") && json.any("label").is_string();
  if (is_surroundings && json.has("label") && !has_name)
    json.refuse("label", "the shape 'surroundings' has label 0; remove the field");
  filling.label = is_surroundings ? 0 : int(index + 1);
  if (has_name)
    filling.label = label_of_name(json, filling.label, labels);
  else if (!is_surroundings)
    filling.label = int(json.count("label", index + 1));
  if (is_surroundings != (filling.label == 0))
    json.refuse("label", "label 0 is reserved for the shape 'surroundings'; choose another label");
}

Scene_liquid read_liquid(const Json_fields& liquid, std::size_t index, Filling_labels& labels) {
  liquid.require_known({"shape", "label", "density", "viscosity", "diffusivity", "velocity"});
  Scene_liquid result;
  read_filling(liquid, index, labels, result);
  result.density = liquid.positive("density");
  result.viscosity = liquid.not_negative("viscosity", 0);
  if (liquid.has("diffusivity"))
    result.diffusivity = liquid.not_negative("diffusivity", 0);
  result.velocity = read_velocity(liquid);
  return result;
}

Scene_gas read_gas(const Json_fields& gas, std::size_t index, Filling_labels& labels) {
  gas.require_known({"shape", "label", "pressure", "exponent"});
  Scene_gas result;
  read_filling(gas, index, labels, result);
  gas.any("pressure");
  result.pressure = gas.not_negative("pressure", 0);
  result.exponent = gas.not_negative("exponent", 1.4);
  return result;
}

/// Reads a number, or an expression in t.
Expression read_flux(const Json_fields& source) {
  const Expression result = source.number_or_expression(
      "flux", {"t"}, "a number, or an expression in t like '0.1*sin(t)'");
  if (result.is_constant() && *result.at({0.}) == 0)
    source.refuse("flux", "must not be 0: the source has no effect; remove the source");
  return result;
}

Scene_source read_source(const Json_fields& source) {
  source.require_known({"center", "radius", "rate", "flux"});
  Scene_source result = {source.point("center"), source.positive("radius"), 0, {}};
  if (source.has("flux")) {
    source.require_not_both("flux", "rate");
    result.flux = read_flux(source);
    return result;
  }
  if (!source.has("rate"))
    source.refuse("rate", "is missing; add it or the field 'flux'");
  result.rate = source.number("rate");
  if (result.rate == 0)
    source.refuse("rate", "must not be 0: the source has no effect; remove the source");
  return result;
}

/// Reads a vector of numbers, or expressions in t for its coordinates.
Vector_in_time read_vector_in_time(const Json_fields& json, const std::string& field) {
  if (!json.any(field).is_string())
    return {json.point(field), {}};
  return {{}, json.vector_in_time(field)};
}

std::vector<Fluid_scene::Tension> read_tensions(const Json_fields& scene,
                                                const Label_names& names) {
  if (!scene.has("surface_tension"))
    return {};
  if (!scene.any("surface_tension").is_array())
    return {read_tension(scene, "surface_tension", {0, 1})};
  std::vector<Fluid_scene::Tension> result;
  for (const Json_fields& tension : scene.objects("surface_tension")) {
    tension.require_known({"labels", "value"});
    const Json& labels = tension.any("labels");
    if (!labels.is_array() || labels.size() != 2)
      tension.refuse("labels", "must be a list of 2 labels");
    result.push_back(read_tension(tension, "value",
                                  {read_label(tension, "labels", labels[0], names),
                                   read_label(tension, "labels", labels[1], names)}));
  }
  return result;
}

/// Reads the box of a part of a side with a number. Without `from` and `to`, the part is the whole
/// side.
std::array<double, 6> read_part(const Json_fields& side, std::size_t number,
                                const std::array<double, 6>& domain) {
  std::array<double, 6> result = domain, whole = domain; // whole: the box of the side
  whole[number / 2] = whole[number / 2 + 3] = domain[number / 2 + 3 * (number % 2)];
  if (side.has("from") || side.has("to")) {
    const auto from = side.point("from"), to = side.point("to");
    for (std::size_t i = 0; i < 3; ++i) {
      if (!(to[i] >= from[i]))
        side.refuse("to", "must not be smaller than 'from' in any coordinate");
      if (from[i] > whole[i + 3] || to[i] < whole[i])
        side.refuse("to", "and 'from' must be corners of a box that meets the side");
      result[i] = from[i];
      result[i + 3] = to[i];
    }
  }
  return result;
}

Scene_inflow read_inflow(const Json_fields& side, std::size_t number,
                         const std::array<double, 6>& domain) {
  if (side.has("velocity"))
    side.refuse("velocity", "applies only together with 'pressure'; remove it");
  return {read_vector_in_time(side, "inflow"), read_part(side, number, domain)};
}

Scene_opening read_opening(const Json_fields& side, std::size_t number,
                           const std::array<double, 6>& domain) {
  if (side.has("inflow"))
    side.refuse("inflow", "cannot be combined with 'pressure'; remove one of them");
  const char* form = side.dimension() == 2
                         ? "a number, or an expression in x, y and t like '1-y'"
                         : "a number, or an expression in x, y, z and t like '1-z'";
  Scene_opening result{side.number_or_expression("pressure", side.coordinate_names({"t"}), form),
                       std::nullopt, read_part(side, number, domain)};
  if (side.has("velocity")) {
    result.velocity = side.point("velocity");
    if ((*result.velocity)[number / 2] != 0)
      side.refuse("velocity", "must be a velocity along the side");
  }
  return result;
}

void read_sides(const Json_fields& sides, Fluid_scene& scene) {
  const auto number = std::size_t(2 * scene.dimension);
  sides.require_known({names_of_sides.begin(), names_of_sides.begin() + number});
  for (std::size_t side = 0; side < number; ++side)
    if (sides.has(names_of_sides[side]) && sides.any(names_of_sides[side]).is_object()) {
      const Json_fields given = sides.object(names_of_sides[side]);
      given.require_known({"inflow", "pressure", "velocity", "from", "to"});
      if (given.has("pressure"))
        scene.openings[side] = read_opening(given, side, scene.domain);
      else
        scene.inflows[side] = read_inflow(given, side, scene.domain);
    } else if (sides.has(names_of_sides[side])) {
      const Vector_in_time velocity = read_vector_in_time(sides, names_of_sides[side]);
      if (velocity.at(0)[side / 2] != 0)
        sides.refuse(names_of_sides[side], "must be a velocity along the side");
      scene.sides[side] = velocity;
    }
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

/// Returns the dimension of a scene, from the number of coordinates of its domain.
int read_dimension(const Json_fields& scene) {
  const Json& domain = scene.any("domain");
  if (!domain.is_array() || (domain.size() != 4 && domain.size() != 6))
    scene.refuse("domain", "must be a list of 6 numbers, or of 4 numbers in the plane");
  return domain.size() == 4 ? 2 : 3;
}

} // namespace

Fluid_scene read_scene(const Json& json) {
  Json_fields scene(json, "the scene");
  scene.require_known({"title", "domain", "edge", "liquids", "gases", "sources", "surface_tension",
                       "field", "gravity", "solids", "sides", "probes", "time_step", "cfl", "end",
                       "implicitness", "interface_tolerance", "adaptation_interval", "relaxation"});
  Fluid_scene result;
  result.json = json;
  result.title = printed_line(scene.text("title", ""));
  result.dimension = read_dimension(scene);
  scene.set_dimension(result.dimension);
  result.domain = scene.box("domain");
  result.edge = scene.positive("edge");
  Filling_labels labels(scene, result.names);
  std::size_t index = 0;
  for (const Json_fields& liquid : scene.objects("liquids"))
    result.liquids.push_back(read_liquid(liquid, index++, labels));
  if (result.liquids.empty())
    scene.refuse("liquids", "must contain at least one liquid");
  for (const Json_fields& gas : scene.objects("gases"))
    result.gases.push_back(read_gas(gas, index++, labels));
  for (const Json_fields& source : scene.objects("sources"))
    result.sources.push_back(read_source(source));
  result.tensions = read_tensions(scene, result.names);
  if (scene.has("field"))
    result.field = read_field(scene.object("field"));
  if (scene.has("gravity"))
    result.gravity = read_vector_in_time(scene, "gravity");
  for (const Json_fields& solid : scene.objects("solids"))
    result.solids.push_back(read_solid(solid));
  if (scene.has("sides"))
    read_sides(scene.object("sides"), result);
  for (const Json_fields& probe : scene.objects("probes"))
    result.probes.push_back(read_probe(probe, result.names));
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

bool is_liquid(const Fluid_scene& scene, int label) {
  return std::any_of(scene.liquids.begin(), scene.liquids.end(),
                     [&](const Scene_liquid& liquid) { return liquid.label == label; });
}

std::vector<std::pair<int, const Fluid_shape*>> shapes_of(const Fluid_scene& scene) {
  std::vector<std::pair<int, const Fluid_shape*>> result;
  for (const Scene_liquid& liquid : scene.liquids)
    result.emplace_back(liquid.label, &liquid.shape);
  for (const Scene_gas& gas : scene.gases)
    result.emplace_back(gas.label, &gas.shape);
  return result;
}

std::string name_of_shape(const Fluid_scene& scene, std::size_t i) {
  const std::size_t liquids = scene.liquids.size();
  return i < liquids ? numbered("liquids", i) : numbered("gases", i - liquids);
}

Fluid_scene find_scene(const std::string& name) {
  const std::map<std::string, std::string> scenes = scene_files();
  const auto found = scenes.find(name);
  if (found == scenes.end() && !exists(name)) {
    std::vector<std::string> names;
    for (const auto& scene : scenes)
      names.push_back(scene.first);
    throw Input_error("there is no file or scene '" + name + "'" +
                      (scenes.empty() ? "; no scenes were found in " + searched_scene_folders()
                                      : advice_on_name(name, names, "scenes")));
  }
  const std::string& path = found == scenes.end() ? name : found->second;
  return read_scene(parse_json(DSC::internal::file_contents(path), name));
}

std::vector<std::array<std::string, 2>> scene_names() {
  const std::map<std::string, std::string> scenes = scene_files();
  if (scenes.empty())
    throw Input_error("no scenes were found in " + searched_scene_folders() +
                      "; install the program again");
  std::vector<std::array<std::string, 2>> result;
  for (const auto& [name, path] : scenes) {
    const Json json = parse_json(DSC::internal::file_contents(path), path);
    result.push_back({name, json.value("title", "")});
  }
  return result;
}

} // namespace dsc
