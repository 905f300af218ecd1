// The parallel solver of saddle point systems. All processes run the same tests.
#include "test.h"

#include <CGAL/Incompressible_fluids_3/Petsc_saddle_point_solver.h>
#include <CGAL/Incompressible_fluids_3/Saddle_point_solver.h>

#include <Eigen/Dense>

namespace {

using System = DSC::Saddle_point_system;
using Vector = System::Vector;
using Entries = std::vector<Eigen::Triplet<double>>;

struct Parts
{
  bool are_coupled, is_closed, have_body;
};

// A system on a grid of vertices. Neighbors share masses, and each pressure acts on the vertices
// around it. In a closed system, a constant pressure exerts no force. Some velocities are
// constrained. The last velocity can be that of a body, on which every third pressure acts.
System random_system(int n, const Parts& parts) {
  std::mt19937 generator(5);
  const auto random = [&generator](double from, double to) {
    return from + (to - from) * double(generator()) / double(std::mt19937::max());
  };
  const auto vertex = [n](int x, int y) { return Eigen::Index(x + n * y); };
  const Eigen::Index m = n * n, all = m + parts.have_body;
  Entries nodal, coupling, b, c;
  System result;
  result.inertia = Vector::Zero(all);
  result.viscosity = Vector::Constant(m, parts.are_coupled ? .2 : 0);
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const Eigen::Index i = vertex(x, y);
      result.inertia(i) = random(2, 3);
      nodal.emplace_back(i, i, result.inertia(i));
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (const auto& [u, v] : {std::pair(x + 1, y), {x, y + 1}, {x - 1, y}, {x, y - 1}}) {
        if (u < 0 || v < 0 || u >= n || v >= n)
          continue;
        const Eigen::Index j = vertex(u, v);
        nodal.emplace_back(i, j, -.4);
        c.emplace_back(i, i, .05);
        c.emplace_back(i, j, -.05);
        const Eigen::Vector3d gradient(random(.5, 1) * (u - x), random(.5, 1) * (v - y),
                                       random(-.2, .2));
        for (int axis = 0; axis < 3; ++axis)
          b.emplace_back(j, 3 * i + axis, gradient(axis));
        sum += gradient;
      }
      for (int axis = 0; axis < 3; ++axis)
        b.emplace_back(i, 3 * i + axis, -sum(axis) + (parts.is_closed ? 0 : .1));
      const Eigen::Vector3d along(random(-1, 1), random(-1, 1), random(-1, 1));
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 3; ++k)
          coupling.emplace_back(3 * i + j, 3 * i + k, along(j) * along(k));
      if (i % 7 == 1)
        result.constrained.push_back({i, Eigen::Matrix3d::Zero()});
      if (i % 7 == 3)
        result.constrained.push_back(
            {i, Eigen::Matrix3d::Identity() - along * along.transpose() / along.squaredNorm()});
    }
  if (parts.have_body) {
    result.velocities_of_bodies = 1;
    result.inertia(m) = 20;
    nodal.emplace_back(m, m, 20);
    for (Eigen::Index p = 0; p < m; p += 3)
      for (int axis = 0; axis < 3; ++axis)
        b.emplace_back(p, 3 * m + axis, random(-1, 1));
  }
  if (parts.is_closed) {
    result.closed.emplace_back();
    for (Eigen::Index p = 0; p < m; ++p)
      result.closed[0].pressures.push_back(p);
    result.closed[0].weight = .3;
  }
  const auto set = [](System::Matrix& matrix, Eigen::Index rows, Eigen::Index columns,
                      const Entries& entries) {
    matrix.resize(rows, columns);
    matrix.setFromTriplets(entries.begin(), entries.end());
  };
  set(result.nodal, all, all, nodal);
  if (parts.are_coupled)
    set(result.coupling, 3 * all, 3 * all, coupling);
  set(result.b, m, 3 * all, b);
  set(result.c, m, m, c);
  return result;
}

double largest(const Vector& v) { return v.lpNorm<Eigen::Infinity>(); }

// Returns whether a vector has the same bits in all processes.
bool is_same_everywhere(const Vector& v) {
  Vector first = v;
  MPI_Bcast(first.data(), int(first.size()), MPI_DOUBLE, 0, PETSC_COMM_WORLD);
  int result = first == v;
  MPI_Allreduce(MPI_IN_PLACE, &result, 1, MPI_INT, MPI_MIN, PETSC_COMM_WORLD);
  return result != 0;
}

void expect_direct_solution(const Parts& parts) {
  SCOPED_TRACE(testing::Message() << parts.are_coupled << parts.is_closed << parts.have_body);
  const System system = random_system(12, parts);
  const Eigen::Index n = 3 * system.nodal.rows(), m = system.c.rows();
  const Vector f = Vector::LinSpaced(n, -1, 2), s = Vector::LinSpaced(m, -1, 1);
  Vector exact_v = Vector::Zero(n), exact_p = Vector::Zero(m);
  DSC::Direct_saddle_point_solver direct;
  direct.factorize(System(system));
  direct.solve(f, s, exact_v, exact_p);
  DSC::Petsc_saddle_point_solver solver;
  Vector v = Vector::Ones(n), p = Vector::Zero(m);
  for (bool is_updated : {false, true}) {
    if (is_updated)
      solver.update(System(system));
    else
      solver.factorize(System(system));
    const unsigned iterations = solver.solve(f, s, v, p, 1e-12);
    EXPECT_LT(iterations, is_updated ? 5u : 100u);
    EXPECT_LT(largest(v - exact_v), 1e-9 * largest(exact_v));
    EXPECT_LT(largest(p - exact_p), 1e-9 * largest(exact_p));
    EXPECT_TRUE(is_same_everywhere(v));
    EXPECT_TRUE(is_same_everywhere(p));
  }
}

} // namespace

TEST(Petsc_saddle_point_solver, agrees_with_direct_solver) {
  for (bool are_coupled : {false, true})
    for (bool is_closed : {false, true})
      for (bool have_body : {false, true})
        expect_direct_solution({are_coupled, is_closed, have_body});
}

// A preconditioner of another system is worse, but the solution is the same.
TEST(Petsc_saddle_point_solver, updates) {
  const System system = random_system(12, {true, false, false});
  const Eigen::Index n = 3 * system.nodal.rows(), m = system.c.rows();
  System similar = system;
  similar.nodal *= 1.3;
  similar.b *= .9;
  const Vector f = Vector::LinSpaced(n, -1, 2), s = Vector::LinSpaced(m, 1, 2);
  std::vector<Vector> solutions;
  for (bool is_updated : {false, true}) {
    DSC::Saddle_point_solver solver;
    solver.use<DSC::Petsc_saddle_point_solver>();
    solver.factorize(System(is_updated ? similar : system));
    if (is_updated)
      solver.update(System(system));
    Vector v = Vector::Zero(n), p = Vector::Zero(m);
    solver.solve(f, s, v, p, 1e-12);
    solutions.push_back(v);
  }
  EXPECT_LT(largest(solutions[1] - solutions[0]), 1e-9 * largest(solutions[0]));
}

TEST(Petsc_saddle_point_solver, changes_nothing_without_solution) {
  const System system = random_system(6, {});
  const Eigen::Index n = 3 * system.nodal.rows(), m = system.c.rows();
  DSC::Petsc_saddle_point_solver solver;
  solver.factorize(System(system));
  Vector f = Vector::Ones(n), v = Vector::Ones(n), p = Vector::Ones(m);
  f(1) = std::numeric_limits<double>::quiet_NaN();
  for (double bad : {std::numeric_limits<double>::quiet_NaN(), 1.}) {
    f(0) = bad;
    EXPECT_THROW(solver.solve(f, Vector::Ones(m), v, p, 1e-12), DSC::Convergence_error);
    EXPECT_TRUE(v == Vector::Ones(n) && p == Vector::Ones(m));
  }
  // Without a closed set, constant pressures are free, and the prescribed volumes contradict this.
  System singular = random_system(6, {false, true, false});
  singular.closed.clear();
  singular.constrained.clear();
  try {
    solver.factorize(std::move(singular));
    solver.solve(Vector::Ones(n), Vector::Ones(m), v, p, 1e-12);
    ADD_FAILURE() << "the system has no solution";
  } catch (const DSC::Convergence_error&) {
  }
  EXPECT_TRUE(v == Vector::Ones(n) && p == Vector::Ones(m));
  v.setOnes();
  solver.factorize(System(system));
  EXPECT_EQ(solver.solve(Vector::Zero(n), Vector::Zero(m), v, p, 1e-12), 0u);
  EXPECT_EQ(largest(v), 0);
}

// Options of PETSc choose the preconditioners. Errors of PETSc are thrown.
TEST(Petsc_saddle_point_solver, reads_options) {
  const System system = random_system(6, {});
  const Eigen::Index n = 3 * system.nodal.rows(), m = system.c.rows();
  Vector v = Vector::Zero(n), p = Vector::Zero(m);
  const auto solve = [&] {
    DSC::Petsc_saddle_point_solver solver;
    solver.factorize(System(system));
    return solver.solve(Vector::Ones(n), Vector::Ones(m), v, p, 1e-12);
  };
  const unsigned iterations = solve();
  PetscOptionsSetValue(nullptr, "-pressure_pc_type", "jacobi");
  v.setZero();
  p.setZero();
  EXPECT_GT(solve(), iterations);
  PetscOptionsClearValue(nullptr, "-pressure_pc_type");
  PetscOptionsSetValue(nullptr, "-ksp_type", "unknown");
  EXPECT_THROW(solve(), DSC::Error);
  PetscOptionsClearValue(nullptr, "-ksp_type");
}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (PetscInitialize(&argc, &argv, nullptr, nullptr) != 0)
    return 1;
  const int result = RUN_ALL_TESTS();
  PetscFinalize();
  return result;
}
