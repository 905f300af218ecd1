// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLUID_SOLIDS_H
#define DSC_FLUID_SOLIDS_H

#include "fluids/fluid_of_dimension.h"
#include "fluids/fluid_scene.h"

#include <array>
#include <string>

namespace dsc {

/// Sets the centers of meshes to the means of their vertices, except for given centers. Files of
/// the scene are searched in `folder`. \throws Input_error if a file cannot be read
void set_centers_of_meshes(const std::string& folder, Fluid_scene& scene);

/// Returns the center of a solid that is no body at a time, see `Scene_solid::center`.
std::array<double, 3> center_of(const Scene_solid& solid, double t);

/// Adds the solids of a scene to a fluid. Files of the scene are searched in `folder`.
/// \throws Input_error if a file cannot be read
template <class Complex>
void add_solids(const Fluid_scene& scene, const std::string& folder, Fluid<Complex>& fluid);

} // namespace dsc

#endif // DSC_FLUID_SOLIDS_H
