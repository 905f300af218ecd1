/*!
\ingroup PkgDeformableSimplicialComplex3Concepts
\cgalConcept

Solves the linear systems of `CGAL::Deformable_simplicial_complexes::Incompressible_fluid`, those of
`CGAL::Deformable_simplicial_complexes::Saddle_point_system`. It must be default constructible.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Direct_saddle_point_solver}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Iterative_saddle_point_solver}
\cgalHasModels{CGAL::Deformable_simplicial_complexes::Saddle_point_solver}
\cgalHasModelsEnd
*/
class SaddlePointSolver
{
public:
  /// takes a matrix, to be solved with until the next call. Where no surface of a liquid is free, the
  /// pressures are known but for a constant.
  void factorize(CGAL::Deformable_simplicial_complexes::Saddle_point_system&& system);

  /// solves for v and p, which hold a guess, and returns a number of iterations.
  unsigned solve(const Eigen::VectorXd& f, const Eigen::VectorXd& s, Eigen::VectorXd& v,
                 Eigen::VectorXd& p) const;
};
