// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_PETSC_SADDLE_POINT_SOLVER_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_PETSC_SADDLE_POINT_SOLVER_H

#include <CGAL/Incompressible_fluids_3/Saddle_point_system.h>
#include <CGAL/Incompressible_fluids_3/internal/parallel/Petsc_equations.h>

#include <memory>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgIncompressibleFluids3Ref

A parallel iterative solver of saddle point systems with PETSc and MPI. All processes of a
communicator call the same functions with the same arguments. Each process stores its own block of
rows of the matrices, and the processes solve together. All of them get the same solution, bit by
bit. The solution depends on the number of processes within the tolerance.

The method is FGMRES (Y. Saad, "A flexible inner-outer preconditioned GMRES algorithm", SIAM J. Sci.
Comput. 14, 1993) with an upper block triangular preconditioner:

- For velocities, each process has an incomplete Cholesky factorization of its block.
- For pressures, it is a cycle of algebraic multigrid (BoomerAMG of hypre, or GAMG if PETSc has no
  hypre) for the Schur complement of the masses, plus a term of the viscosity.

The number of iterations grows slowly with the number of vertices.

The options of PETSc apply: `-ksp_type`, `-ksp_monitor`, `-ksp_view` and others for the method,
options with the prefixes `-velocity_` and `-pressure_` for the two preconditioners, such as
`-pressure_pc_type gamg`. The tolerance is the argument of `solve()`, so `-ksp_rtol` has no effect.

The unknowns are scaled so that the norm of residuals is the norm in which the fluid checks the
solution.

\pre `PetscInitialize()` has been called, and `PetscFinalize()` is called after the destruction of
all solvers.

\cgalModels{SaddlePointSolver}
*/
class Petsc_saddle_point_solver
{
public:
  using System = Saddle_point_system; ///< the system to be solved
  using Vector = System::Vector;      ///< a vector of unknowns

  /// Constructs a solver for the processes of a communicator.
  explicit Petsc_saddle_point_solver(MPI_Comm communicator = PETSC_COMM_WORLD)
      : m_communicator(communicator) {}

  /// Distributes the matrices, and computes the preconditioner.
  /// \param system the system
  /// \param number_of_threads ignored: a process uses one thread
  /// \throws Convergence_error if the preconditioner does not exist
  /// \throws Error if PETSc reports an error
  void factorize(System&& system, unsigned number_of_threads = 1) {
    static_cast<void>(number_of_threads);
    m_equations.reset(); // frees memory first
    m_equations = std::make_unique<internal::Petsc_equations>(m_communicator, std::move(system));
  }

  /// Replaces the system by a similar one, and keeps the preconditioner. Takes linear time.
  /// \throws Error if PETSc reports an error
  void update(System&& system) { m_equations->update(std::move(system)); }

  /// Solves for the velocities v and the pressures p. Returns the number of iterations.
  /// \param f,s the right side
  /// \param v,p the initial guess, and then the solution
  /// \param tolerance the tolerance of the true residual, relative to the right side. If rounding
  /// prevents convergence to it, a residual of 1e-9 is accepted.
  /// \throws Convergence_error if the iterations do not converge; then v and p are unchanged
  /// \throws Error if PETSc reports an error, for example on its options
  unsigned solve(const Vector& f, const Vector& s, Vector& v, Vector& p, double tolerance) {
    return m_equations->solve(f, s, v, p, tolerance);
  }

private:
  MPI_Comm m_communicator;
  std::unique_ptr<internal::Petsc_equations> m_equations;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_PETSC_SADDLE_POINT_SOLVER_H
