// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_FLUID_ERRORS_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_FLUID_ERRORS_H

#include <CGAL/Deformable_simplicial_complexes/exceptions.h>

#include <CGAL/Simple_cartesian.h>

#include <cstdint>
#include <string>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgIncompressibleFluids3Ref

is thrown when a linear system has no solution, or when the residual of the solution found is above
the bound.
*/
class Convergence_error : public Error
{
public:
  /// constructs the error; the arguments are returned by the functions below.
  Convergence_error(const std::string& message, double residual, double bound)
      : Error(message), m_residual(residual), m_bound(bound) {}

  /// returns the norm of the true residual divided by the norm of the right side. It is infinite if
  /// there is no finite solution.
  double residual() const { return m_residual; }

  /// returns the largest residual that would have been accepted.
  double bound() const { return m_bound; }

private:
  double m_residual, m_bound;
};

/// \ingroup PkgIncompressibleFluids3Ref
/// The reasons for which a time step of `Incompressible_fluid_3` is undone.
enum class Fluid_failure_3 {
  equations, ///< the linear equations have no solution, or the residual is above the bound
  motion,    ///< the motion raises the energy by more than forces and sources explain
  mesh       ///< changes of the mesh raise the energy by more than forces and sources explain
};

/// \ingroup PkgIncompressibleFluids3Ref
/// A failed attempt at a time step, or at a part of one. The attempt has been undone.
struct Fluid_repetition_3
{
  using Point = Simple_cartesian<double>::Point_3; ///< of space

  Fluid_failure_3 cause; ///< why it failed
  double time;           ///< at the beginning of the attempt
  double dt;             ///< length of the attempt
  double amount;         ///< the residual divided by the right side, or the unexplained rise of the
                         ///< energy divided by the energy, see `Incompressible_fluid::advance()`
  Point place;           ///< the flattest cell, or the fastest vertex, of liquids
};

/*!
\ingroup PkgIncompressibleFluids3Ref

is thrown when a time step of `Incompressible_fluid_3` fails, and fails again after remeshing and
with shorter time steps. The fluid and its complex are in their state before the step.
*/
class Fluid_step_error : public Error
{
public:
  using Point = Simple_cartesian<double>::Point_3; ///< of space

  /// constructs the error; the arguments are returned by the functions below.
  Fluid_step_error(const std::string& message, std::uint64_t step,
                   const Fluid_repetition_3& last_attempt)
      : Error(message), m_step(step), m_last_attempt(last_attempt) {}

  /// returns the number of the step that failed; the first step has the number 1.
  std::uint64_t step() const { return m_step; }

  /// returns the last attempt: the cause, the time, the length of the time step and the place.
  const Fluid_repetition_3& last_attempt() const { return m_last_attempt; }

private:
  std::uint64_t m_step;
  Fluid_repetition_3 m_last_attempt;
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_FLUID_ERRORS_H
