// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLUID_SHAPES_H
#define DSC_FLUID_SHAPES_H

#include "fluids/fluid_scene.h"
#include "input/surface.h"

#include <array>
#include <cstddef>
#include <set>
#include <vector>

namespace dsc {

/// Returns the number of parts, rounded, at least 1.
/// \throws Input_error if the number exceeds the memory of any computer
std::size_t number_of_parts(double parts);

/// Returns the coordinates of lines, and of lines between them at distances of about `edge`.
/// \throws Input_error as number_of_parts() does
std::vector<double> divided_lines(const std::set<double>& lines, double edge);

/// Return the closed surface of a shape. The target edge length is `edge`, unless the shape defines
/// the number of triangles.
/// \throws Input_error if there would be too many triangles
Surface surface_of(const Ball_shape& ball, double edge);
Surface surface_of(const Cylinder_shape& shape, double edge);

/// Returns whether a point is in a shape, or may be in it.
bool is_about(const Fluid_shape& shape, const std::array<double, 3>& p, int dimension);

} // namespace dsc

#endif // DSC_FLUID_SHAPES_H
