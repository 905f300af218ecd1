// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLUID_START_H
#define DSC_FLUID_START_H

#include "fluids/fluid_of_dimension.h"
#include "fluids/fluid_scene.h"

#include <memory>

namespace dsc {

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

} // namespace dsc

#endif // DSC_FLUID_START_H
