// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_PICTURE_H
#define DSC_PICTURE_H

#include <array>
#include <string>
#include <vector>

namespace dsc {

/// A triangle of a surface, and the label behind it, which determines its color.
struct Picture_triangle
{
  std::array<std::array<double, 3>, 3> corners;
  int label;
};

/// Draws triangles into a PNG file, in parallel projection from the front, the right and above,
/// with z upwards.
/// \throws Input_error if the file cannot be written
void write_picture(const std::string& path, const std::vector<Picture_triangle>& triangles);

} // namespace dsc

#endif // DSC_PICTURE_H
