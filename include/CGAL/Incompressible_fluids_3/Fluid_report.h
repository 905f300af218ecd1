// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_FLUID_REPORT_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_FLUID_REPORT_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Incompressible_fluids_3/fluid_errors.h>

namespace CGAL::Deformable_simplicial_complexes {

/// \ingroup PkgIncompressibleFluids3Ref
/// The volume, mass, energies and momenta of all liquids together, and the field that they carry.
struct Fluid_balance
{
  using Vector = Epick::Vector_3; ///< a vector in space

  double volume = 0;           ///< volume of all liquids
  double mass = 0;             ///< mass: density times volume
  double kinetic_energy = 0;   ///< kinetic energy
  double potential_energy = 0; ///< potential energy of gravity, 0 at the origin; 0 on a torus
  /// Surface energy: surface tension times area; the term of a wetted wall can be negative.
  double surface_energy = 0;
  double gas_energy = 0; ///< the work of gases that expand without bound; for exponents up to 1, it
                         ///< is defined up to a constant
  double field_integral = 0;         ///< the integral of the field that liquids carry
  double least_field = 0;            ///< the least value of the field at a vertex of a liquid
  double greatest_field = 0;         ///< the greatest value of the field at a vertex of a liquid
  Vector momentum = Vector(0, 0, 0); ///< momentum: mass times velocity
  Vector angular_momentum = Vector(0, 0, 0); ///< angular momentum about the origin; 0 on a torus

  /// Returns the sum of the four energies.
  double energy() const { return kinetic_energy + potential_energy + surface_energy + gas_energy; }
};

/// \ingroup PkgIncompressibleFluids3Ref
/// A connected component of a gas.
struct Fluid_gas
{
  std::uint32_t component; ///< the number of the component, `Complex::component()`
  int label;               ///< the label of the gas
  double volume;           ///< the present volume
  double pressure;         ///< the present pressure
};

/*!
\ingroup PkgIncompressibleFluids3Ref

The report of a time step of `Incompressible_fluid`.

In the plane, vectors lie in the plane, and the angular momentum is perpendicular to it.

\tparam Complex an instance of `Deformable_simplicial_complex_2` or `Deformable_simplicial_complex_3`
*/
template <class Complex> struct Fluid_report
{
  using Vector = Epick::Vector_3; ///< a vector in space

  double time = 0;      ///< the time after the step
  double dt = 0;        ///< the length of the step
  Fluid_balance before; ///< the balance at the beginning
  /// The balance after the motion, before changes of the mesh and of its topology. If the step was
  /// divided, it is the balance of the last part.
  Fluid_balance moved;
  /// The balance at the end; the difference to `moved` is due to the mesh, and to
  /// `work_of_tensions`.
  Fluid_balance after;
  /// The greatest velocity of a vertex after the motion. If the step was divided, it is the
  /// greatest value of all parts.
  double greatest_velocity = 0;
  /// The greatest change of a velocity by the equations of motion.
  double greatest_change_of_velocity = 0;
  /// The greatest change of a velocity by the rigid motion, on a torus the translation, that
  /// restores the momenta of a connected component after changes of the mesh.
  double greatest_correction = 0;
  /// The greatest relative error of a volume of a connected component, before the volumes were
  /// restored.
  double volume_correction = 0;
  /// The greatest relative error of a volume of a connected component at the end.
  double volume_error = 0;
  double lost_volume = 0; ///< the volume of connected components that vanished
  /// The volume that sources and sides added, less the volume that they removed.
  double gained_volume = 0;
  /// The volume that entered through each side of the domain, less the volume that left, in the
  /// order x minimum, x maximum, y minimum, and so on. `gained_volume` includes it.
  std::array<double, 6> volume_through_sides = {};
  /// The surface energy that the diffusion of the field added, because surface tensions changed:
  /// the sum of area times change of tension over all facets of the interface.
  double work_of_tensions = 0;
  unsigned solutions = 0;  ///< the number of solutions of linear systems, without failed attempts
  unsigned iterations = 0; ///< the number of iterations of the solver, in all these solutions
  /// The true residual of the equations, divided by their largest term, in the norm weighted by the
  /// inverse of the diagonal.
  double residual = 0;
  /// The number of liquid cells that were too flat to have a viscosity.
  std::size_t flat_cells = 0;
  unsigned parts = 1; ///< the number of time steps that the step was divided into
  std::vector<Fluid_repetition> repetitions; ///< the attempts that were undone, in order
  /// The number of vertices constrained by solids, or by the distance to sides of the domain. If
  /// the step was divided, it is the number in the last part.
  std::size_t contacts = 0;
  /// Whether the search for the vertices constrained by contacts converged.
  bool contacts_settled = true;
  /// The depth in a solid of the deepest vertex, after the step. Barycenters of cells inside
  /// liquids count as vertices.
  double depth_in_solids = 0;
  /// The mean force of liquids on each solid in the step, in the order of `add_solid()` and
  /// `add_body()`.
  std::vector<Vector> forces_on_solids;
  /// The mean torque of liquids about the origin on each solid, in the same order. On a torus, the
  /// positions of vertices are images next to the body, or in the box.
  std::vector<Vector> torques_on_solids;
  double seconds_of_solver = 0,  ///< wall-clock time (s) of linear systems; not deterministic
      seconds_of_mesh = 0;       ///< wall-clock time (s) of all other work; not deterministic
  Improvement_report adaptation; ///< the adaptation of the mesh before the step
  /// The deformation of the mesh by the step, without corrections of volumes. If the step was
  /// divided, it is the deformation of the last part, but with the events of all parts.
  Deformation_report<Complex> deformation;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_FLUID_REPORT_H
