// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_FLUID_STATE_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_FLUID_STATE_H

#include <array>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/// \ingroup PkgIncompressibleFluids3Ref
/// The boundary conditions of liquids at a solid.
struct Wall_behavior
{
  /// Contact angle in degrees, in [0, 180]: the angle in the liquid between the solid and the
  /// surface.
  double contact_angle = 90;
  /// Whether a liquid in contact moves with the wall (no-slip), instead of sliding along it (slip).
  bool sticks = false;
  /// Whether the liquid may leave the wall where the normal force would be negative. With surface
  /// tension, the vertices of wetted facets stay on the wall. They leave it only when the contact
  /// line recedes along the wall.
  bool separates = true;
};

/// \ingroup PkgIncompressibleFluids3Ref
/// The state of `Incompressible_fluid`, in addition to the state of its complex, as plain
/// numbers. It contains the field and the places and motions of bodies. It does not contain the
/// media, gravity, solids, sides, sources and given values of the field.
struct Fluid_state
{
  double time = 0;         ///< the present time
  std::uint64_t steps = 0; ///< the number of steps done
  /// The number of remaining steps with a larger `implicitness` after a change of topology.
  std::uint32_t damped_steps = 0;
  bool knows_accelerations = false; ///< whether accelerations of a previous step are known
  /// Velocities, accelerations and pressures of finite vertices, by time stamp.
  std::vector<std::array<double, 7>> motion;
  /// Where liquids meet: the index of a vertex, the label of a liquid, and the numbers of this
  /// liquid less those of `motion`.
  std::vector<std::tuple<std::size_t, int, std::array<double, 7>>> deviations;
  /// The field at finite vertices, by time stamp; empty if no field was set.
  std::vector<double> field;
  /// The volumes to be preserved, by component.
  std::vector<std::pair<std::uint32_t, double>> volumes;
  /// For each component of a gas, a pressure and the volume at that pressure.
  std::vector<std::pair<std::uint32_t, std::array<double, 2>>> gases;
  /// For each body, the numbers of its center, rotation, velocity and angular velocity, see
  /// `Rigid_body_3`.
  std::vector<std::array<double, 13>> bodies;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_FLUID_STATE_H
