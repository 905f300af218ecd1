// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_FLUID_ERRORS_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_FLUID_ERRORS_H

#include <CGAL/Mesh_support/Error.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstdint>
#include <string>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgIncompressibleFluids3Ref

The exception that is thrown if a linear system has no solution, or if the residual of the solution
is above its bound.
*/
class Convergence_error : public Error
{
public:
  /// Constructs the error. The member functions return the arguments.
  Convergence_error(const std::string& message, double residual, double bound)
      : Error(message), m_residual(residual), m_bound(bound) {}

  /// Returns the norm of the residual, relative to the norm of the right side or of the largest
  /// term of the equations, as the solver defines it. It is infinite if there is no finite
  /// solution.
  double residual() const { return m_residual; }

  /// Returns the largest residual that would have been accepted.
  double bound() const { return m_bound; }

private:
  double m_residual, m_bound;
};

/// \ingroup PkgIncompressibleFluids3Ref
/// The reasons for which an attempt at a time step of `Incompressible_fluid` is undone.
enum class Fluid_failure {
  equations, ///< the linear equations have no solution, or the residual is above the bound
  /// The energy rises by more than moving walls, bodies, sources and liquid that passes through
  /// sides supply, and the motion causes at least half of the rise. On a torus, gravity also
  /// supplies energy.
  motion,
  /// The energy rises by more than moving walls, bodies, sources and liquid that passes through
  /// sides supply, and changes of the mesh cause the larger part. On a torus, gravity also supplies
  /// energy.
  mesh,
  /// The volume of a component cannot be restored: its relative error is above 0.05.
  volume,
  /// A wall jumps: its displacement in the step and its velocity differ by more than an edge.
  walls
};

/// \ingroup PkgIncompressibleFluids3Ref
/// An attempt at a time step, or at a part of one, that failed and was undone.
struct Fluid_repetition
{
  using Point = Epick::Point_3; ///< a point in space

  Fluid_failure cause; ///< the reason of the failure
  double time;         ///< the time at the beginning of the attempt
  double dt;           ///< the length of the attempt
  /// For `equations`, the relative residual; for `volume`, the relative error of the volume; for
  /// `walls`, the jump in edges; otherwise the unexplained rise of the energy, relative to the
  /// amount of energy, see `Incompressible_fluid::advance()`.
  double amount;
  /// For `equations`, the barycenter of the liquid cell of lowest quality; for `walls`, a vertex at
  /// the wall; otherwise the vertex of greatest velocity.
  Point place;
};

/*!
\ingroup PkgIncompressibleFluids3Ref

The exception that is thrown if all attempts at a time step of `Incompressible_fluid` fail. The
fluid and its complex are in their state before the step.
*/
class Fluid_step_error : public Error
{
public:
  using Point = Epick::Point_3; ///< a point in space

  /// Constructs the error. The member functions return the arguments.
  Fluid_step_error(const std::string& message, std::uint64_t step,
                   const Fluid_repetition& last_attempt)
      : Error(message), m_step(step), m_last_attempt(last_attempt) {}

  /// Returns the number of the step that failed. The first step has the number 1.
  std::uint64_t step() const { return m_step; }

  /// Returns the last attempt: the cause, the time, the length of the time step and the place.
  const Fluid_repetition& last_attempt() const { return m_last_attempt; }

private:
  std::uint64_t m_step;
  Fluid_repetition m_last_attempt;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_FLUID_ERRORS_H
