// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_FLUID_REPORT_3_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_FLUID_REPORT_3_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Improvement_report.h>
#include <CGAL/Incompressible_fluids_3/fluid_errors.h>

#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/// \ingroup PkgIncompressibleFluids3Ref
/// What liquids have, all together.
struct Fluid_balance_3
{
  using Vector = Simple_cartesian<double>::Vector_3; ///< of space

  double volume = 0;                         ///< of all liquids
  double mass = 0;                           ///< density times volume
  double kinetic_energy = 0;                 ///< of motion
  double potential_energy = 0;               ///< in gravity, 0 at the origin
  double surface_energy = 0;                 ///< tension times area; of wet walls less than none
  double gas_energy = 0;                     ///< what gases would give until they fill all space;
                                             ///< for exponents up to 1 that or less by any constant
  Vector momentum = Vector(0, 0, 0);         ///< mass times velocity
  Vector angular_momentum = Vector(0, 0, 0); ///< about the origin

  /// The sum of the four.
  double energy() const { return kinetic_energy + potential_energy + surface_energy + gas_energy; }
};

/// \ingroup PkgIncompressibleFluids3Ref
/// A connected part of a gas.
struct Fluid_gas_3
{
  std::uint32_t component; ///< `Complex::component()`
  int label;               ///< of the gas
  double volume;           ///< now
  double pressure;         ///< now
};

/*!
\ingroup PkgIncompressibleFluids3Ref
What a step of `Incompressible_fluid_3` did.
\tparam Complex an instance of `Deformable_simplicial_complex_3`
*/
template <class Complex> struct Fluid_report_3
{
  using Vector = Simple_cartesian<double>::Vector_3; ///< of space

  double time = 0;              ///< after the step
  double dt = 0;                ///< length of the step
  Fluid_balance_3 before;       ///< at the beginning
  Fluid_balance_3 moved;        ///< when all has moved, before the mesh was changed or its topology
  Fluid_balance_3 after;        ///< in the end: what differs from `moved` is due to the mesh
  double greatest_velocity = 0; ///< of a vertex, after the step
  double greatest_change_of_velocity = 0; ///< of a vertex in the step, by forces
  double greatest_correction = 0; ///< of the velocity of a vertex, by a rigid motion of its part,
                                  ///< so that changes of the mesh keep momenta
  double volume_correction =
      0;                    ///< by which a part was off before its volume was restored, relative
  double volume_error = 0;  ///< by which one still is, relative: what could not be restored yet
  double lost_volume = 0;   ///< of parts that vanished
  double gained_volume = 0; ///< by sources, less what drained
  unsigned solutions = 0;   ///< linear systems solved
  unsigned iterations = 0;  ///< of the solver, in all of them
  double residual = 0;      ///< the true residual of the equations relative to their largest term,
                            ///< in the norm of the diagonal
  std::size_t flat_cells =
      0;              ///< cells of liquids that were too flat to have a viscosity in the step
  unsigned parts = 1; ///< time steps that the step was divided into
  std::vector<Fluid_repetition_3> repetitions; ///< attempts at the step that were undone, in order
  std::size_t contacts = 0;             ///< vertices held by solids, or off sides of the domain
  bool contacts_settled = true;         ///< whether it was found which vertices are to be held
  double depth_in_solids = 0;           ///< of the deepest vertex, after the step
  std::vector<Vector> forces_on_solids; ///< by liquids, in the order in which solids were added
  double seconds_of_solver = 0,
         seconds_of_mesh = 0;    ///< elapsed: these vary, and those of the deformation
  Improvement_report adaptation; ///< of the mesh, before the step
  Deformation_report<Complex>
      deformation; ///< of the mesh by the step, but for what restores volumes; of the last part if
                   ///< there are several, with the events of all
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_FLUID_REPORT_3_H
