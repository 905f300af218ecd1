// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluids/fluid_scene_parts.h"

#include "input/files.h"
#include "output/label_titles.h"

namespace dsc {
namespace {

constexpr double most_amplitude = .5; // in radii
constexpr std::size_t highest_mode = 100;

std::size_t read_mode(const Json_fields& json) {
  const std::size_t result = json.count("mode", 0);
  if (result > highest_mode)
    json.refuse("mode", "must be at most 100");
  return result;
}

double read_amplitude(const Json_fields& shape) {
  const double result = shape.number("amplitude", 0);
  if (!(std::abs(result) <= most_amplitude))
    shape.refuse("amplitude", "must be from -0.5 to 0.5");
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

/// Throws if the field `triangles` is given in the plane.
void require_no_triangles_in_plane(const Json_fields& shape) {
  if (shape.dimension() == 2 && shape.has("triangles"))
    shape.refuse("triangles", "applies only in space; use the field 'edge' of the scene");
}

Ball_shape read_ball(const Json_fields& shape) {
  shape.require_known({"type", "center", "radius", "mode", "amplitude", "triangles"});
  require_both_or_none(shape, "mode", "amplitude");
  require_no_triangles_in_plane(shape);
  return {shape.point("center"), shape.positive("radius"), read_mode(shape), read_amplitude(shape),
          shape.count("triangles", 0)};
}

Box_shape read_box(const Json_fields& shape) {
  shape.require_known({"type", "from", "to"});
  return box_shape(shape.corners());
}

Cylinder_shape read_cylinder(const Json_fields& shape) {
  if (shape.dimension() == 2)
    shape.refuse("type", "a cylinder exists only in space; use a ball or a box in the plane");
  shape.require_known({"type", "from", "to", "radius", "amplitude", "wave_length"});
  require_both_or_none(shape, "amplitude", "wave_length");
  const Cylinder_shape column{shape.point("from"), shape.point("to"), shape.positive("radius"),
                              read_amplitude(shape),
                              shape.has("wave_length") ? shape.positive("wave_length") : 0};
  if (column.from == column.to)
    shape.refuse("to", "must differ from 'from': the cylinder has no length");
  return column;
}

File_shape read_file(const Json_fields& shape) {
  shape.require_known({"type", "file", "part", "center", "radius", "triangles"});
  require_no_triangles_in_plane(shape);
  const File_shape result{shape.text("file"),
                          shape.text("part", ""),
                          {shape.point("center"), shape.positive("radius")},
                          shape.count("triangles", 0)};
  if (shape.dimension() == 2 && extension(result.file) != "wkt")
    shape.refuse("file", "must be a .wkt file in the plane");
  if (shape.dimension() == 2 && !result.part.empty())
    shape.refuse("part", "applies only in space; remove it");
  return result;
}

Pool_shape read_pool(const Json_fields& shape) {
  shape.require_known({"type", "level", "height"});
  Pool_shape result{shape.number("level"), {}};
  if (!shape.has("height"))
    return result;
  std::vector<std::string> variables = shape.coordinate_names();
  variables.pop_back();
  result.height =
      shape.expression("height", variables, 1,
                       shape.dimension() == 2 ? "an expression in x like '1+0.1*cos(x)'"
                                              : "an expression in x and y like '1+0.1*cos(x)'");
  return result;
}

/// Returns the field for the label of a probe, and checks that the probe has no other field.
Scene_probe probe_of_label(const Json_fields& probe, const char* field, Scene_probe::Kind kind,
                           const Label_names& names) {
  probe.require_known({"name", field});
  Scene_probe result;
  result.name = probe.text("name");
  result.kind = kind;
  result.label = read_label(probe, field, probe.any(field), names);
  return result;
}

/// Reads the given values of a field on the sides of the domain and on free surfaces.
void read_given_values(const Json_fields& fixed, Scene_field& result) {
  std::vector<std::string> places(names_of_sides.begin(),
                                  names_of_sides.begin() + 2 * fixed.dimension());
  places.push_back("surface");
  fixed.require_known(places);
  const std::vector<std::string> variables = fixed.coordinate_names({"t"});
  const std::string form = "a number, or an expression in the coordinates and t like '1+0.1*x'";
  for (std::size_t side = 0; side + 1 < places.size(); ++side)
    if (fixed.has(places[side]))
      result.on_sides[side] = fixed.number_or_expression(places[side], variables, form);
  if (fixed.has("surface"))
    result.on_surface = fixed.number_or_expression("surface", variables, form);
}

} // namespace

Fluid_shape read_shape(const Json_fields& shape) {
  shape.require_known({"type", "center", "radius", "mode", "amplitude", "triangles", "from", "to",
                       "wave_length", "file", "part", "level", "height"}); // "type" may be misspelt
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

int read_label(const Json_fields& json, const std::string& field, const Json& value,
               const Label_names& names) {
  if (value.is_number_integer() &&
      std::abs(value.get<double>()) <= (std::numeric_limits<int>::max)())
    return value.get<int>();
  if (!value.is_string())
    json.refuse(field, "must be an integer of 32 bits, or a name");
  const auto name = value.get<std::string>();
  const std::optional<int> label = label_with_name(name, names);
  if (!label)
    json.refuse(field, unknown_label(name, names));
  return *label;
}

Scene_probe read_probe(const Json_fields& probe, const Label_names& names) {
  using Kind = Scene_probe::Kind;
  const bool has_mode = probe.has("mode");
  if (has_mode && probe.has("height_at"))
    probe.refuse("height_at", "a probe measures either a mode or a height; write two probes");
  if (probe.has("circularity_of"))
    return probe_of_label(probe, "circularity_of", Kind::circularity, names);
  if (probe.has("centroid_of"))
    return probe_of_label(probe, "centroid_of", Kind::centroid, names);
  if (probe.has("velocity_of"))
    return probe_of_label(probe, "velocity_of", Kind::velocity, names);
  if (has_mode)
    probe.require_known({"name", "mode", "center"});
  else if (probe.has("at"))
    probe.require_known({"name", "at"});
  else
    probe.require_known({"name", "at", "height_at", "mode", "center", "circularity_of",
                         "centroid_of", "velocity_of"});
  Scene_probe result;
  result.name = probe.text("name");
  if (probe.has("at")) {
    result.kind = Kind::point;
    result.point = probe.point("at");
    return result;
  }
  if (has_mode) {
    result.kind = Kind::mode;
    result.mode = read_mode(probe);
    result.center = probe.point("center");
    return result;
  }
  if (probe.has("center"))
    probe.refuse("center", "has no effect without the field 'mode'");
  result.kind = Kind::height;
  if (probe.dimension() == 2)
    result.place = {probe.number("height_at"), 0};
  else
    result.place = probe.numbers<2>("height_at");
  return result;
}

Scene_field read_field(const Json_fields& field) {
  field.require_known({"initial", "diffusivity", "fixed"});
  Scene_field result{
      field.number_or_expression("initial", field.coordinate_names(),
                                 "a number, or an expression in the coordinates like '1+0.1*x'"),
      field.not_negative("diffusivity", 0),
      {},
      {}};
  if (field.has("fixed"))
    read_given_values(field.object("fixed"), result);
  return result;
}

Fluid_scene::Tension read_tension(const Json_fields& json, const std::string& field,
                                  const std::array<int, 2>& labels) {
  if (!json.any(field).is_string())
    return {labels, json.not_negative(field, 0), {}};
  const Expression expression =
      json.expression(field, {"c"}, 1, "a number, or an expression in c like '1-0.1*c'");
  if (expression.is_constant())
    expression.refuse("does not depend on the field c");
  return {labels, 0, expression};
}

} // namespace dsc
