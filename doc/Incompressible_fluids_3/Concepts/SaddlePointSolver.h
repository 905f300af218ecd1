/*!
\ingroup PkgIncompressibleFluids3Concepts
\cgalConcept

Solves the equations of `CGAL::Incompressible_fluid_3` for velocities and pressures. A matrix is
factorized once and solved for one right side or more; two to some dozens of them make up a step.

\cgalRefines `DefaultConstructible`

\cgalHasModelsBegin
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Direct_saddle_point_solver}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Iterative_saddle_point_solver}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Saddle_point_solver}
\cgalHasModelsEnd
*/
class SaddlePointSolver
{
public:
  /// takes a system in place of the one before, for the calls of `update()` and `solve()` that
  /// follow. `a` is positive definite, `c` positive semidefinite. Where no surface is free, the
  /// means of closed sets keep the whole from being singular. The number of threads must not change
  /// a bit of what follows.
  /// \throws CGAL::Deformable_simplicial_complexes::Convergence_error if it is singular
  void factorize(CGAL::Deformable_simplicial_complexes::Saddle_point_system&& system,
                 unsigned number_of_threads);

  /// takes a system like that of the last `factorize()`, for the calls of `solve()` that follow: of
  /// the same size and pattern, with other values, of as little difference as a step of the flow
  /// makes, and other velocities that are held, and closed sets. What was factorized may serve on
  /// to precondition it.
  /// \throws CGAL::Deformable_simplicial_complexes::Convergence_error as `factorize()` does
  void update(CGAL::Deformable_simplicial_complexes::Saddle_point_system&& system);

  /*!
  solves

      P (a v - b^T p)     = P f,    v = P v,
        -b v - c p - d p  = -s.

  \param f,s the right side
  \param v,p a guess, and then the solution
  \param tolerance of the residual, relative to the right side: volumes are kept as well as that
  \return the number of iterations, for the report
  \throws CGAL::Deformable_simplicial_complexes::Convergence_error if there is no solution, or the
  true residual of the solution found is above the tolerance. The fluid repeats the time step then,
  see `CGAL::Incompressible_fluid_3`. It also checks the residual itself, to 1e-8.
  */
  unsigned solve(const Eigen::VectorXd& f, const Eigen::VectorXd& s, Eigen::VectorXd& v,
                 Eigen::VectorXd& p, double tolerance);
};
