// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLUID_START_H
#define DSC_FLUID_START_H

#include "fluid_scene.h"
#include "tracked_complex_3.h"

#include <CGAL/Incompressible_fluid_3.h>

#include <memory>
#include <string>

namespace dsc {

using Fluid = CGAL::Incompressible_fluid_3<Tracked_complex_3::Complex>;

/// \throws Input_error if a file is missing; Usage_error if there is a folder, but no file
void require_files(const Fluid_scene& scene, const std::string& folder);

/// The liquids of a scene where they begin. Files that it names are in a folder.
/// \throws Input_error if they cannot be built, as they overlap, or a file cannot be read
Tracked_complex_3::Complex start_of_scene(const Fluid_scene& scene, const std::string& folder);

/// \throws Input_error if a liquid or gas fills nothing, or a source meets no liquid
void require_effect(const Fluid_scene& scene, const Tracked_complex_3::Complex& complex);

/// With the solids of the scene. \throws Input_error if a file cannot be read
std::unique_ptr<Fluid> fluid_of_scene(const Fluid_scene& scene, const std::string& folder,
                                      Tracked_complex_3::Complex& complex);

/// \throws Input_error if a liquid is inside a solid
void require_outside_of_solids(const Fluid_scene& scene, const Fluid& fluid);

/// Those of the scene.
void set_velocities(const Fluid_scene& scene, Fluid& fluid);

} // namespace dsc

#endif // DSC_FLUID_START_H
