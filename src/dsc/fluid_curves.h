// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLUID_CURVES_H
#define DSC_FLUID_CURVES_H

#include "fluid_scene.h"
#include "start_curves.h"

#include <string>

namespace dsc {

/// Return the closed curve of a shape in the plane. No edge is much longer than `edge`. A disk
/// without `amplitude` becomes a polygon of the same area.
/// \throws Input_error if there would be too many edges, or the file cannot be read
Curve curve_of(const Ball_shape& disk, double edge);
/// \param path the file, in place of the name in the shape
Curve curve_of(const File_shape& shape, const std::string& path, double edge);

} // namespace dsc

#endif // DSC_FLUID_CURVES_H
