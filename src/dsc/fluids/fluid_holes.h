// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLUID_HOLES_H
#define DSC_FLUID_HOLES_H

#include "fluids/fluid_shapes.h"

#include <type_traits>

namespace dsc {

/// The region of a solid at the start. Liquids have a hole there.
struct Hole
{
  std::size_t solid; ///< index in the scene
  Fluid_shape shape; ///< a box or a ball
};

/// Returns the holes of a scene: the regions of boxes and balls with liquids outside, at time 0.
/// \throws Input_error if a box is rotated at time 0
std::vector<Hole> holes_of(const Fluid_scene& scene);

/// Returns the label of the cells in holes: 0, or a label without liquid and gas if label 0 is a
/// liquid.
int label_of_holes(const Fluid_scene& scene);

/// Returns whether the insides of two boxes have a common point.
bool boxes_overlap(const Box_shape& a, const Box_shape& b, int dimension);

/// Returns whether a hole contains a part of a shape, or may contain it. The domain of the scene
/// bounds the shape.
bool may_meet(const Hole& hole, const Fluid_shape& shape, const Fluid_scene& scene);

/// The nearest point of the boundary of a hole.
struct Nearest_boundary
{
  double distance;              ///< negative inside the hole
  std::array<double, 3> offset; ///< vector to the point
};

/// Returns the point of the boundary of a hole that is nearest to a point.
Nearest_boundary nearest_boundary(const Hole& hole, const std::array<double, 3>& p, int dimension);

/// Returns whether a hole is in a liquid: whether the innermost boundary around it is the boundary
/// of a liquid, or whether label 0 is a liquid and there is no boundary around it.
/// \tparam Boundary `Curve` or `Surface`
/// \param boundary the boundary of the hole
/// \param others labeled boundaries
/// \throws Input_error if the boundary of the hole crosses the boundary of a liquid, or is around
/// it
template <class Boundary>
bool is_in_liquid(const Fluid_scene& scene, const Hole& hole, const Boundary& boundary,
                  const std::vector<Boundary>& others);

/// Moves the points of a curve or surface to a circle or sphere, in the directions from its center.
template <class Boundary> void put_on_ball(const Ball_shape& ball, Boundary& boundary) {
  for (auto& p : boundary.points) {
    std::array<double, 3> from_center = {};
    double length = 0;
    for (int i = 0; i < p.dimension(); ++i) {
      from_center[std::size_t(i)] = p[i] - ball.center[std::size_t(i)];
      length = std::hypot(length, from_center[std::size_t(i)]);
    }
    for (std::size_t i = 0; i < 3; ++i)
      from_center[i] = ball.center[i] + from_center[i] * (ball.radius / length);
    p = from_coordinates<std::decay_t<decltype(p)>>(from_center);
  }
}

} // namespace dsc

#endif // DSC_FLUID_HOLES_H
