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

using Picture_color = std::array<double, 3>; ///< red, green and blue, from 0 to 1
using Picture_point = std::array<double, 2>; ///< to the right and upwards

/// A convex polygon of a plane picture.
struct Picture_polygon
{
  std::vector<Picture_point> corners; ///< in any orientation
  Picture_color color;
};

/// A line of a plane picture.
struct Picture_line
{
  std::array<Picture_point, 2> ends;
  Picture_color color = {0, 0, 0};
};

/// A plane picture: polygons that do not overlap, and lines in front of them.
struct Plane_picture
{
  std::vector<Picture_polygon> polygons;
  std::vector<Picture_line> lines;
};

/// Draws polygons and lines into a PNG file. All polygons are visible.
/// \throws Input_error if the file cannot be written
void write_picture(const std::string& path, const Plane_picture& picture);

/// Returns the color of a label: white for 0, and light colors for all others.
Picture_color picture_color(int label);

/// Returns the color of a number from 0, dark blue, to 1, yellow.
Picture_color color_of_number(double number);

} // namespace dsc

#endif // DSC_PICTURE_H
