// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_PICTURE_H
#define DSC_PICTURE_H

#include "programs/errors.h"

#include <CGAL/Mesh_files/internal/pictures/colors.h>

#include <vector>

namespace dsc {

using DSC::internal::color_of_label;
using DSC::internal::color_of_number;
using Picture_color = DSC::internal::Color;
using Picture_point = std::array<double, 3>; ///< in the plane, the last coordinate is 0

/// A convex polygon of a picture.
struct Picture_polygon
{
  std::vector<Picture_point> corners; ///< in any orientation
  Picture_color color;
};

/// A line of a picture.
struct Picture_line
{
  std::array<Picture_point, 2> ends;
  Picture_color color = {0, 0, 0};
};

/// Polygons, and lines in front of them.
struct Picture
{
  std::vector<Picture_polygon> polygons;
  std::vector<Picture_line> lines;
  /// Whether polygons are shaded and seen in parallel projection from the front, the right and
  /// above, with z upwards. Otherwise, they are in the plane of the picture and do not overlap.
  bool is_in_space = false;
};

/// Draws a picture into a PNG file. All polygons are within its frame.
/// \throws Input_error if the file cannot be written
void write_picture(const std::string& path, const Picture& picture);

} // namespace dsc

#endif // DSC_PICTURE_H
