// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLUID_SHAPES_H
#define DSC_FLUID_SHAPES_H

#include "fluid_scene.h"
#include "surface.h"

#include <array>
#include <cstddef>

namespace dsc {

/// How many parts of about the length of an edge something is cut into: at least 1.
/// \throws Input_error if that is more than any computer could hold
std::size_t number_of_parts(double parts);

/// The closed surface of a shape, with edges of about a length, if the shape does not tell how many
/// triangles it has. \throws Input_error if there would be too many
Surface surface_of(const Ball_shape& ball, double edge);
Surface surface_of(const Box_shape& shape, double edge);
Surface surface_of(const Cylinder_shape& shape, double edge);

/// Whether a place is in a shape, or may be.
bool is_about(const Fluid_shape& shape, const std::array<double, 3>& p);

} // namespace dsc

#endif // DSC_FLUID_SHAPES_H
