// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLUID_START_H
#define DSC_FLUID_START_H

#include "fluid_scene.h"
#include "tracked_complex_3.h"

#include <CGAL/Incompressible_fluid_3.h>
#include <CGAL/Incompressible_fluids_3/compiled_3.h>

#include <memory>
#include <string>

namespace dsc {

using Fluid = CGAL::Incompressible_fluid_3<Tracked_complex_3::Complex>;

/// Checks that the files of a scene exist.
/// \throws Input_error if a file is missing
/// \throws Usage_error if a folder is given, but the scene has no file
void require_files(const Fluid_scene& scene, const std::string& folder);

/// Returns the complex with the initial liquids of a scene. Files of the scene are searched in
/// `folder`.
/// \throws Input_error if the complex cannot be built, for example because liquids overlap, or a
/// file cannot be read
Tracked_complex_3::Complex start_of_scene(const Fluid_scene& scene, const std::string& folder);

/// Checks that the shapes of the scene have an effect.
/// \throws Input_error if a liquid or gas has no cells, or a source contains no liquid
void require_effect(const Fluid_scene& scene, const Tracked_complex_3::Complex& complex);

/// Returns the fluid in the complex, with the solids of the scene.
/// \throws Input_error if a file cannot be read
std::unique_ptr<Fluid> fluid_of_scene(const Fluid_scene& scene, const std::string& folder,
                                      Tracked_complex_3::Complex& complex);

/// Checks that all liquids are outside of the solids.
/// \throws Input_error if a liquid is inside a solid
void require_outside_of_solids(const Fluid_scene& scene, const Fluid& fluid);

/// Sets the initial velocities of the scene.
void set_velocities(const Fluid_scene& scene, Fluid& fluid);

} // namespace dsc

#endif // DSC_FLUID_START_H
