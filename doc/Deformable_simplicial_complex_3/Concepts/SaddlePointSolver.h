/*!
\ingroup PkgDeformableSimplicialComplex3Concepts
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
  /// takes a matrix in place of the one before, for the calls of `solve()` that follow. `a` is positive
  /// definite, `c` positive semidefinite. Where no surface is free, pressures that are constant are in
  /// the kernel of the whole; any of them will do.
  /// \throws CGAL::Deformable_simplicial_complexes::Error if it is singular otherwise
  void factorize(CGAL::Deformable_simplicial_complexes::Saddle_point_system&& system);

  /*!
  solves

      (  a  -b^T ) (v)   ( f)
      ( -b  -c   ) (p) = (-s).

  Volumes are kept as well as this is solved: residuals should be about 1e-12 of the right side.

  \param f,s the right side
  \param v,p a guess, and then the solution
  \return the number of iterations, for the report
  \throws CGAL::Deformable_simplicial_complexes::Error if there is no solution, or it is not found
  */
  unsigned solve(const Eigen::VectorXd& f, const Eigen::VectorXd& s, Eigen::VectorXd& v,
                 Eigen::VectorXd& p) const;
};
