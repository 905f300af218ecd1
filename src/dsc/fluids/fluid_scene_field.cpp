// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluids/fluid_scene_parts.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace dsc {
namespace {

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
