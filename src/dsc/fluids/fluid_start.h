// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLUID_START_H
#define DSC_FLUID_START_H

#include "fluids/fluid_of_dimension.h"
#include "fluids/fluid_scene.h"

namespace dsc {

/// Returns the complex with the initial liquids of a scene of its dimension. Files of the scene are
/// searched in `folder`.
/// \throws Input_error if the complex cannot be built, for example because liquids overlap, or a
/// file cannot be read
template <class Complex>
Complex start_of_scene(const Fluid_scene& scene, const std::string& folder);

/// Checks that the shapes of the scene have an effect.
/// \throws Input_error if a liquid or gas has no cells, or a source contains no liquid
template <class Complex> void require_effect(const Fluid_scene& scene, const Complex& complex);

/// Returns the fluid in the complex, with the solids of the scene.
/// \pre The meshes of the scene have been read, see `read_meshes()`.
template <class Complex>
std::unique_ptr<Fluid<Complex>> fluid_of_scene(const Fluid_scene& scene, Complex& complex);

/// Sets gravity and the velocities of sides to those of a time.
/// \throws Input_error if a value is not finite
/// \throws Usage_error if the velocity of a side is not along the side
template <class Complex> void set_time(const Fluid_scene& scene, double t, Fluid<Complex>& fluid);

/// Checks that all liquids are outside of the solids.
/// \throws Input_error if a liquid is inside a solid
template <class Complex>
void require_outside_of_solids(const Fluid_scene& scene, const Fluid<Complex>& fluid);

/// Sets the initial velocities of the scene.
template <class Complex> void set_velocities(const Fluid_scene& scene, Fluid<Complex>& fluid);

/// Returns the complex with the initial liquids of a scene that contains a pool. If all other
/// shapes and all holes in liquids are boxes, their faces are faces of cells. Otherwise, the
/// complex is built from the labels of points. \throws Input_error if the complex cannot be built
template <class Complex> Complex start_with_pool(const Fluid_scene& scene);

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

#endif // DSC_FLUID_START_H
