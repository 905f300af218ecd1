// Solves the smallest system, with one vertex and one pressure, by the component Petsc.
#include <CGAL/Incompressible_fluids_3/Petsc_saddle_point_solver.h>

#include <cmath>
#include <cstdlib>
#include <utility>

namespace DSC = CGAL::Deformable_simplicial_complexes;

int main(int argc, char** argv) {
  if (PetscInitialize(&argc, &argv, nullptr, nullptr) != 0)
    return EXIT_FAILURE;
  Eigen::VectorXd v = Eigen::VectorXd::Zero(3), p = Eigen::VectorXd::Zero(1);
  {
    DSC::Saddle_point_system system;
    system.nodal.resize(1, 1);
    system.nodal.insert(0, 0) = 1;
    system.b.resize(1, 3);
    for (int axis = 0; axis < 3; ++axis)
      system.b.insert(0, axis) = 1;
    system.c.resize(1, 1);
    system.c.insert(0, 0) = 1;
    system.inertia = Eigen::VectorXd::Ones(1);
    system.viscosity = Eigen::VectorXd::Zero(1);
    DSC::Petsc_saddle_point_solver solver;
    solver.factorize(std::move(system));
    solver.solve(Eigen::VectorXd::Ones(3), Eigen::VectorXd::Zero(1), v, p, 1e-12);
  }
  PetscFinalize();
  // v - b^T p = f and b v + c p = 0 have the solution p = -3/4.
  return std::abs(p(0) + .75) < 1e-9 && std::abs(v(0) - .25) < 1e-9 ? EXIT_SUCCESS : EXIT_FAILURE;
}
