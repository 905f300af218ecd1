// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLUID_BOXES_H
#define DSC_FLUID_BOXES_H

#include "fluid_scene.h"
#include "start_curves.h"
#include "surface.h"

#include <vector>

namespace dsc {

/// A box of a liquid or gas.
struct Labelled_box
{
  int label;
  Box_shape box;
};

/// Returns the boxes of a scene in groups: boxes whose boundaries meet are in the same group.
/// Groups are in the order of their first boxes.
std::vector<std::vector<Labelled_box>> groups_of_boxes(const Fluid_scene& scene);

/// Return the boundary of the region of each label in boxes. Boxes of the same label that touch or
/// overlap form one region. Where boxes of different labels overlap, the last box counts. Common
/// boundaries of two regions have the same facets.
/// \param edge target edge length
/// \throws Input_error if there would be too many facets
std::vector<Surface> surfaces_of_boxes(const std::vector<Labelled_box>& boxes, double edge);
std::vector<Curve> curves_of_boxes(const std::vector<Labelled_box>& boxes, double edge);

} // namespace dsc

#endif // DSC_FLUID_BOXES_H
