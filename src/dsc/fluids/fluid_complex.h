// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLUID_COMPLEX_H
#define DSC_FLUID_COMPLEX_H

#include "fluids/fluid_of_dimension.h"
#include "fluids/fluid_scene.h"

#include <string>

namespace dsc {

/// Returns the complex with the initial liquids of a scene of its dimension. Files of the scene are
/// searched in `folder`.
/// \throws Input_error if the complex cannot be built, for example because liquids overlap, or a
/// file cannot be read
template <class Complex>
Complex start_of_scene(const Fluid_scene& scene, const std::string& folder);

} // namespace dsc

#endif // DSC_FLUID_COMPLEX_H
