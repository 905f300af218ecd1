// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLUID_SCENE_PARTS_H
#define DSC_FLUID_SCENE_PARTS_H

#include "fluids/fluid_scene.h"
#include "scenes/json_fields.h"

#include <array>
#include <cstddef>
#include <string>

namespace dsc {

/// Read a part of a scene. The dimension of the fields is the dimension of the scene.
/// \throws Usage_error if a field is unknown, missing, out of range or without effect
Fluid_shape read_shape(const Json_fields& shape);
Scene_probe read_probe(const Json_fields& probe, const Label_names& names);
Scene_field read_field(const Json_fields& field);

/// Reads the surface tension between two labels: a number, or an expression in c.
/// \throws Usage_error
Fluid_scene::Tension read_tension(const Json_fields& json, const std::string& field,
                                  const std::array<int, 2>& labels);

/// Returns the label that a value of a field gives by its number or its name.
/// \throws Usage_error
int read_label(const Json_fields& json, const std::string& field, const Json& value,
               const Label_names& names);

/// Returns the field `mode`, at most 100.
/// \throws Usage_error
std::size_t read_mode(const Json_fields& json);

} // namespace dsc

#endif // DSC_FLUID_SCENE_PARTS_H
