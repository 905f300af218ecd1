// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLUID_FILES_H
#define DSC_FLUID_FILES_H

#include "fluids/fluid_scene.h"

#include <string>

namespace dsc {

/// Returns the path of a file of a scene. Relative paths are searched in `folder`.
std::string place_of(const std::string& file, const std::string& folder);

/// Checks that the files of a scene exist.
/// \throws Input_error if a file is missing
/// \throws Usage_error if a folder is given, but the scene has no file
void require_files(const Fluid_scene& scene, const std::string& folder);

/// Reads the surfaces of the solids that are meshes.
/// \throws std::runtime_error if a file cannot be read
void read_meshes(const std::string& folder, Fluid_scene& scene);

} // namespace dsc

#endif // DSC_FLUID_FILES_H
