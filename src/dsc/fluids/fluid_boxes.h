// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLUID_BOXES_H
#define DSC_FLUID_BOXES_H

#include "fluids/fluid_scene.h"
#include "input/start_curves.h"
#include "input/surface.h"

#include <utility>
#include <vector>

namespace dsc {

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

} // namespace dsc

#endif // DSC_FLUID_BOXES_H
