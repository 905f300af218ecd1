// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLUID_SCENE_PARTS_H
#define DSC_FLUID_SCENE_PARTS_H

#include "fluids/fluid_scene.h"
#include "scenes/json_fields.h"

namespace dsc {

/// Returns the name of an entry of a list of a scene.
inline std::string numbered(const char* list, std::size_t i) {
  return std::string(list) + "[" + std::to_string(i) + "]";
}

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

/// Checks the consistency of the fields of a scene: labels, pairs of labels, names, and fields that
/// have no effect wherever the liquids move.
/// \param json the scene, for messages
/// \throws Usage_error
void require_consistent(const Fluid_scene& scene, const Json_fields& json);

/// Returns the files of the installed scenes, by the names of the scenes. The first existing folder
/// is used: the installed folder, relative to the program, or the folder of the source tree.
/// Returns an empty map if neither exists.
std::map<std::string, std::string> scene_files();

/// Returns the end of a message about missing scenes: the folders that scene_files() searches.
std::string searched_scene_folders();

} // namespace dsc

#endif // DSC_FLUID_SCENE_PARTS_H
