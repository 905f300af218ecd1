// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLUID_SHAPES_H
#define DSC_FLUID_SHAPES_H

#include "fluids/fluid_scene.h"
#include "input/start_curves.h"
#include "input/surface.h"

#include <set>

namespace dsc {

/// Returns the point or vector with given coordinates. In the plane, the third one is ignored.
template <class Result> Result from_coordinates(const std::array<double, 3>& p) {
  if constexpr (Result::Ambient_dimension::value == 2)
    return Result(p[0], p[1]);
  else
    return Result(p[0], p[1], p[2]);
}

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

/// A box in which liquids have a hole.
struct Box_hole
{
  Box_shape box;
  bool is_in_liquid; ///< whether there is a liquid where no box of the scene is
};

/// A box of a liquid or gas, or a hole in liquids.
struct Labeled_box
{
  int label;
  Box_shape box;
  bool is_hole = false;
  /// Of a hole: the boxes that it meets, in their order, and whether each is a box of a liquid.
  std::vector<std::pair<Box_shape, bool>> boxes_around = {};
  bool is_in_liquid = false; ///< of a hole, see `Box_hole`
};

/// Returns the boxes of a scene and the holes in them, in groups: boxes whose boundaries meet are
/// in the same group. Holes are behind all other boxes, and holes without liquid are left out.
/// Groups are in the order of their first boxes.
std::vector<std::vector<Labeled_box>> groups_of_boxes(const Fluid_scene& scene,
                                                      const std::vector<Box_hole>& holes);

/// Return the boundary of the region of each label in boxes. Boxes of the same label that touch or
/// overlap form one region. Where boxes of different labels overlap, the last box counts. A hole
/// counts only where it is in a liquid. Common boundaries of two regions have the same facets.
/// \param edge target edge length
/// \throws Input_error if there would be too many facets
std::vector<Surface> surfaces_of_boxes(const std::vector<Labeled_box>& boxes, double edge);
std::vector<Curve> curves_of_boxes(const std::vector<Labeled_box>& boxes, double edge);

/// Returns the value of the Legendre polynomial of a degree at z, by recurrence.
inline double legendre(std::size_t degree, double z) {
  double before = 0, value = 1;
  for (std::size_t n = 0; n < degree; ++n)
    before = std::exchange(value, ((2 * double(n) + 1) * z * value - double(n) * before) /
                                      (double(n) + 1));
  return value;
}

} // namespace dsc

#endif // DSC_FLUID_SHAPES_H
