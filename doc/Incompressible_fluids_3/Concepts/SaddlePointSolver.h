/*!
\ingroup PkgIncompressibleFluids3Concepts
\cgalConcept

A solver for the velocities and pressures of `CGAL::Incompressible_fluid_3`. A matrix is factorized once and solved for
one or more right-hand sides. A time step needs between two and a few dozen solutions.

\cgalRefines{DefaultConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Direct_saddle_point_solver}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Iterative_saddle_point_solver}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Petsc_saddle_point_solver}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Saddle_point_solver}
\cgalHasModelsEnd
*/
class SaddlePointSolver
{
public:
  /// Replaces the system for the following calls of `update()` and `solve()`. The matrix `a` is positive definite,
  /// and `c` is positive semidefinite. Without a free surface, the means of closed sets keep the system
  /// nonsingular. The number of threads must not change any bit of the results.
  /// \throws CGAL::Deformable_simplicial_complexes::Convergence_error if the system is singular
  void factorize(CGAL::Deformable_simplicial_complexes::Saddle_point_system&& system,
                 unsigned number_of_threads);

  /// Replaces the system by a similar one, for the following calls of `solve()`. Size and pattern are those of the
  /// last `factorize()`. Values differ by as much as one time step changes them. Constrained velocities and closed sets
  /// can differ. The last factorization can serve as a preconditioner.
  /// \throws CGAL::Deformable_simplicial_complexes::Convergence_error if the system is singular
  void update(CGAL::Deformable_simplicial_complexes::Saddle_point_system&& system);

  /*!
  Solves

      P (a v - b^T p)     = P f,    v = P v,
        -b v - c p - d p  = -s.

  \param f,s the right-hand side
  \param v,p the initial guess, and then the solution
  \param tolerance the tolerance of the residual, relative to the right-hand side. Volumes are kept with the same
         tolerance.
  \return the number of iterations, for the report
  \throws CGAL::Deformable_simplicial_complexes::Convergence_error if there is no solution, or if the true residual
  of the solution is above the tolerance. The fluid then repeats the time step, see `CGAL::Incompressible_fluid_3`. The
  fluid also checks the residual itself.
  */
  unsigned solve(const Eigen::VectorXd& f, const Eigen::VectorXd& s, Eigen::VectorXd& v,
                 Eigen::VectorXd& p, double tolerance);
};
