// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_SIDE_BEHAVIOR_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_SIDE_BEHAVIOR_H

#include <array>
#include <functional>
#include <optional>

namespace CGAL::Deformable_simplicial_complexes {

/// \ingroup PkgIncompressibleFluids3Ref
/// The boundary condition of liquids at a side of the domain: slip, or no-slip with the velocity of
/// the side. Liquid can pass through a part of the side, with a given velocity or against a given
/// pressure.
struct Side_behavior
{
  /// The velocity of the side for the no-slip condition. Its component perpendicular to the side
  /// has no effect. Without a velocity, the condition is slip.
  std::optional<std::array<double, 3>> velocity;

  /// The velocity with which liquid enters the domain at a point of the side and a time, or nothing
  /// where the side is a wall. The function can be empty. A vertex of a liquid at which it returns
  /// a velocity does not move. New liquid has the label of the liquid at the vertex. A component
  /// without a free surface needs an outlet.
  ///
  /// The function can also return velocities with which liquid leaves the domain. Where a surface
  /// of a liquid ends in the inlet, its vertex does not move, so do not prescribe an outflow there.
  std::function<std::optional<std::array<double, 3>>(const std::array<double, 3>&, double)> inflow =
      {};

  /// The pressure outside at a point of the side and a time, or nothing where the side is a wall.
  /// The pressure is relative to void. The function can be empty. A vertex of a liquid at which it
  /// returns a pressure is open, and liquid passes there in both directions with a velocity that
  /// the equations determine. The vertex stays on the side. Liquid that enters has the label
  /// of the liquid at the vertex. With slip, no force acts along the open part. With no-slip, the
  /// liquid has the component of `velocity` along the side, except at vertices of interfaces. Where
  /// a surface ends at the open part, the surface beyond it pulls with the same tension. Where
  /// there is an inflow, the pressure has no effect.
  std::function<std::optional<double>(const std::array<double, 3>&, double)> pressure = {};
};

namespace internal {

/// The boundary conditions at the sides of the domain, in the order of `Boundary_class`.
using Side_behaviors = std::array<Side_behavior, 6>;

} // namespace internal
} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_SIDE_BEHAVIOR_H
