// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_FLUID_STATE_3_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_FLUID_STATE_3_H

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/// \ingroup PkgIncompressibleFluids3Ref
/// What a liquid does at a solid.
struct Wall_behavior
{
  /// in the liquid, between solid and surface, in degrees, in [0, 180]
  double contact_angle = 90;
  /// whether the liquid goes with the wall where it touches it, instead of sliding
  bool sticks = false;
  /// whether the liquid may leave the wall where it would have to be pulled; what surface tension
  /// makes wet is left along the wall only, as the edge of the liquid recedes
  bool separates = true;
};

/// \ingroup PkgIncompressibleFluids3Ref
/// Everything that `Incompressible_fluid_3` adds to the state of its complex, as plain numbers.
struct Fluid_state_3
{
  double time = 0;                           ///< now
  std::uint64_t steps = 0;                   ///< done
  std::uint32_t damped_steps = 0;            ///< to come
  bool knows_accelerations = false;          ///< whether there was a step
  std::vector<std::array<double, 7>> motion; ///< velocities, accelerations and pressures of finite
                                             ///< vertices, by time stamp
  std::vector<std::pair<std::uint32_t, double>> volumes; ///< that components are to have
  std::vector<std::pair<std::uint32_t, std::array<double, 2>>> gases; ///< of components of gas: a
                                                                      ///< pressure, and the volume
                                                                      ///< at that pressure
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_FLUID_STATE_3_H
