// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLUID_POOL_H
#define DSC_FLUID_POOL_H

#include "fluids/fluid_of_dimension.h"
#include "fluids/fluid_scene.h"

namespace dsc {

/// Returns the complex with the initial liquids of a scene that contains a pool. If all other
/// shapes and all holes in liquids are boxes, their faces are faces of cells. Otherwise, the
/// complex is built from the labels of points. \throws Input_error if the complex cannot be built
template <class Complex> Complex start_with_pool(const Fluid_scene& scene);

} // namespace dsc

#endif // DSC_FLUID_POOL_H
