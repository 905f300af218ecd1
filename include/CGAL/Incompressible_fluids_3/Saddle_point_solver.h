// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_SADDLE_POINT_SOLVER_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_SADDLE_POINT_SOLVER_H

#include <CGAL/Deformable_simplicial_complexes/For_each_index.h>
#include <CGAL/Incompressible_fluids_3/Saddle_point_system.h>
#include <CGAL/Incompressible_fluids_3/fluid_errors.h>
#include <CGAL/Incompressible_fluids_3/internal/solvers/Incomplete_factorization.h>
#include <CGAL/Incompressible_fluids_3/internal/solvers/minimal_residuals.h>
#include <CGAL/Incompressible_fluids_3/internal/solvers/pressure_matrix.h>
#include <CGAL/Incompressible_fluids_3/internal/solvers/relative_residual.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

[[noreturn]] inline void throw_singular_equations() {
  throw Convergence_error("the equations of the flow are singular: cells may be flat",
                          std::numeric_limits<double>::infinity(), largest_residual);
}

} // namespace internal

/*!
\ingroup PkgIncompressibleFluids3Ref

Solves saddle point systems by a sparse Cholesky factorization LDL^T, which exists for any order of
the unknowns, as the matrix is quasi-definite (R. J. Vanderbei, "Symmetric quasidefinite matrices",
SIAM J. Optim. 5, 1995). To be preferred up to about five hundred vertices.

\cgalModels `SaddlePointSolver`
*/
class Direct_saddle_point_solver
{
public:
  using System = Saddle_point_system; ///< what is solved
  using Vector = System::Vector;      ///< unknowns

  /// Takes a matrix. \throws Convergence_error if it is singular.
  /// About n^2 for n unknowns in space, and memory of n^(4/3). Takes one thread.
  void factorize(System&& system, unsigned number_of_threads = 1) {
    static_cast<void>(number_of_threads);
    m_system = std::move(system);
    // Velocities that are held make no difference to others, and have any equation of their own.
    // The weighed mean of a closed set is an unknown more, by which the matrix stays sparse.
    const Eigen::Index n = 3 * m_system.nodal.rows(), m = m_system.c.rows(),
                       all = n + m + Eigen::Index(m_system.closed.size());
    std::vector<Eigen::Triplet<double>> entries;
    for_each_entry(m_system.nodal, [&](Eigen::Index i, Eigen::Index j, double value) {
      for (int axis = 0; axis < 3; ++axis)
        entries.emplace_back(3 * i + axis, 3 * j + axis, value);
    });
    const auto add = [&entries](Eigen::Index i, Eigen::Index j, double value) {
      entries.emplace_back(i, j, value);
    };
    if (m_system.coupling.rows() > 0)
      for_each_entry(m_system.coupling, add);
    for_each_entry(m_system.b, [&](Eigen::Index i, Eigen::Index j, double value) {
      add(n + i, j, -value);
      add(j, n + i, -value);
    });
    for_each_entry(m_system.c, [&](Eigen::Index i, Eigen::Index j, double value) {
      add(n + i, n + j, -value);
    });
    for (Eigen::Index k = n + m; k < all; ++k) {
      const auto& set = m_system.closed[std::size_t(k - n - m)];
      for (Eigen::Index p : set.pressures) {
        add(k, n + p, -1);
        add(n + p, k, -1);
      }
      add(k, k, double(set.pressures.size()) / set.weight);
    }
    Symmetric whole(all, all);
    whole.setFromTriplets(entries.begin(), entries.end());
    if (!m_system.held.empty()) {
      Symmetric free(all, all), fixed(all, all);
      free.setIdentity();
      entries.clear();
      for (const auto& h : m_system.held)
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j) {
            const double value = (i == j) - h.projection(i, j);
            free.coeffRef(3 * h.vertex + i, 3 * h.vertex + j) -= value;
            add(3 * h.vertex + i, 3 * h.vertex + j, m_system.inertia(h.vertex) * value);
          }
      fixed.setFromTriplets(entries.begin(), entries.end());
      whole = Symmetric(free * whole * free) + fixed;
    }
    m_whole = whole.triangularView<Eigen::Lower>();
    Symmetric definite = m_whole;
    definite.diagonal().segment(n, m) *= above_zero;
    m_solver.compute(definite);
    if (m_solver.info() != Eigen::Success)
      internal::throw_singular_equations();
  }

  /// Takes one like that of before. As `factorize()`.
  void update(System&& system) { factorize(std::move(system)); }

  /// Solves for v and p. Returns how often the solution was refined.
  /// \param tolerance of the true residual, relative to its largest term; 1e-8 is the least
  /// \throws Convergence_error if the solution is not finite, or the residual is above the tolerance
  unsigned solve(const Vector& f, const Vector& s, Vector& v, Vector& p,
                 double tolerance = 0) const {
    static constexpr unsigned refinements = 2; // each is nearer by what c was changed by
    Vector right = Vector::Zero(m_whole.rows());
    right.head(f.size()) = f;
    right.segment(f.size(), s.size()) = -s;
    m_system.project(right);
    Vector x = m_solver.solve(right);
    for (unsigned k = 0; k < refinements; ++k)
      x += m_solver.solve(right - m_whole.selfadjointView<Eigen::Lower>() * x);
    const Vector velocities = x.head(f.size()), pressures = x.segment(f.size(), s.size());
    const double bound = (std::max)(tolerance, internal::largest_residual),
                 residual = internal::relative_residual(m_system, f, s, velocities, pressures);
    if (!(residual <= bound))
      throw Convergence_error("the equations of the flow have no accurate solution: the time step "
                              "may be too short or too long for numbers, or cells flat",
                              residual, bound);
    v = velocities;
    p = pressures;
    return refinements;
  }

private:
  using Symmetric = Eigen::SparseMatrix<double>;

  template <class Function>
  static void for_each_entry(const System::Matrix& matrix, const Function& f) {
    for (Eigen::Index row = 0; row < matrix.rows(); ++row)
      for (System::Matrix::InnerIterator i(matrix, row); i; ++i)
        f(row, i.col(), i.value());
  }

  // c is semidefinite only.
  static constexpr double above_zero = 1 + 1e-8;

  System m_system;
  Eigen::SimplicialLDLT<Symmetric> m_solver;
  Symmetric m_whole; // lower triangle
};

/*!
\ingroup PkgIncompressibleFluids3Ref

Solves saddle point systems by the method of minimal residuals (C. C. Paige and M. A. Saunders,
"Solution of sparse indefinite systems of linear equations", SIAM J. Numer. Anal. 12, 1975), for
velocities preconditioned by an incomplete Cholesky factorization of what treats coordinates alike,
for pressures by that of what masses make of them, and by viscosity (J. Cahouet and J.-P. Chabard,
"Some fast 3D finite element solvers for the generalized Stokes problem", Int. J. Numer. Methods
Fluids 8, 1988). Memory is linear in the number of unknowns, time almost. The number of threads
changes no bit.

\cgalModels `SaddlePointSolver`
*/
class Iterative_saddle_point_solver
{
public:
  using System = Saddle_point_system; ///< what is solved
  using Vector = System::Vector;      ///< unknowns

  /// Takes a matrix. \throws Convergence_error if it is not definite where it should be.
  void factorize(System&& system, unsigned number_of_threads = 1) {
    m_for_each.emplace(number_of_threads);
    update(std::move(system));
    std::array<bool, 2> exists;
    (*m_for_each)(
        2,
        [&](std::size_t k) {
          exists[k] =
              k == 0
                  ? m_of_pressures.compute(internal::pressure_matrix(*m_for_each, m_system, m_bt))
                  : m_of_velocities.compute(free_part(m_system));
        },
        2);
    if (!exists[0] || !exists[1])
      internal::throw_singular_equations();
  }

  /// Takes one like that of before, whose factorizations stay. Linear.
  void update(System&& system) {
    m_system = std::move(system);
    m_bt = m_system.b.transpose();
  }

  /// Solves for v and p, which hold a guess. Returns the number of iterations.
  /// \param tolerance of the true residual, relative to the right side, as the preconditioner weighs
  /// them; where rounding permits no better, 1e-9 is enough
  /// \throws Convergence_error if they do not converge
  unsigned solve(const Vector& f, const Vector& s, Vector& v, Vector& p, double tolerance) {
    const Eigen::Index n = f.size(), m = s.size();
    Vector x(n + m), right(n + m);
    m_system.project(v);
    x << v, p;
    right << f, -s;
    m_system.project(right);
    const unsigned result = internal::minimal_residuals(
        *m_for_each, [this](const Vector& in, Vector& out) { multiply(in, out); },
        [this](const Vector& in, Vector& out) { precondition(in, out); }, right, tolerance, x);
    v = x.head(n);
    p = x.tail(m);
    return result;
  }

private:
  void multiply(const Vector& x, Vector& y) const {
    const Eigen::Index n = m_system.nodal.rows(), m = m_system.c.rows();
    const bool has_coupling = m_system.coupling.rows() > 0;
    internal::for_each_block(*m_for_each, n + m, [&](Eigen::Index begin, Eigen::Index size) {
      for (Eigen::Index i = begin; i < begin + size; ++i)
        if (i < n) {
          Eigen::Vector3d sum = Eigen::Vector3d::Zero();
          for (Row k(m_system.nodal, i); k; ++k)
            sum += k.value() * x.segment<3>(3 * k.col());
          for (int axis = 0; axis < 3; ++axis) {
            const Eigen::Index row = 3 * i + axis;
            y(row) = sum(axis) - product(m_bt, row, x, 3 * n) +
                     (has_coupling ? product(m_system.coupling, row, x, 0) : 0);
          }
        } else
          y(2 * n + i) = -product(m_system.b, i - n, x, 0) - product(m_system.c, i - n, x, 3 * n);
    });
    for (const auto& set : m_system.closed)
      set.add(-set.weight * set.mean(x, 3 * n), y, 3 * n);
    m_system.project(y);
  }

  void precondition(const Vector& x, Vector& y) {
    const Eigen::Index n = 3 * m_system.nodal.rows(), m = m_system.c.rows();
    (*m_for_each)(
        2,
        [&](std::size_t k) {
          if (k == 0) {
            Vector pressures = x.tail(m);
            remove_means(pressures);
            Vector result(m);
            m_of_pressures.solve(pressures, result);
            result += m_system.viscosity.cwiseProduct(pressures);
            remove_means(result);
            y.tail(m) = result;
            for (const auto& set : m_system.closed)
              set.add(set.mean(x, n) / set.weight, y, n);
          } else
            m_of_velocities.solve(x.head(n), y.head(n));
        },
        2);
    m_system.project(y);
  }

  // The preconditioner treats the means of closed sets and what is left of pressures apart.
  void remove_means(Vector& pressures) const {
    for (const auto& set : m_system.closed)
      set.add(-set.mean(pressures), pressures);
  }

  // Of a row, with entries of x from one on.
  static double product(const System::Matrix& matrix, Eigen::Index row, const Vector& x,
                        Eigen::Index from) {
    double result = 0;
    for (Row k(matrix, row); k; ++k)
      result += k.value() * x(from + k.col());
    return result;
  }

  // What treats coordinates alike, of velocities that are not held at all.
  static Eigen::SparseMatrix<double> free_part(const System& system) {
    std::vector<char> is_fixed(std::size_t(system.nodal.rows()), false);
    for (const auto& h : system.held)
      is_fixed[std::size_t(h.vertex)] = h.projection.isZero();
    Eigen::SparseMatrix<double> result = system.nodal.triangularView<Eigen::Lower>();
    result.prune([&](Eigen::Index i, Eigen::Index j, double) {
      return i == j || !(is_fixed[std::size_t(i)] || is_fixed[std::size_t(j)]);
    });
    return result;
  }

  using Row = System::Matrix::InnerIterator;

  System m_system;
  System::Matrix m_bt; // of b
  internal::Incomplete_factorization<3> m_of_velocities;
  internal::Incomplete_factorization<1> m_of_pressures;
  std::optional<For_each_index> m_for_each;
};

/*!
\ingroup PkgIncompressibleFluids3Ref

Solves small saddle point systems directly, others by iterations: whichever takes less time.

\cgalModels `SaddlePointSolver`
*/
class Saddle_point_solver
{
public:
  using System = Saddle_point_system; ///< what is solved
  using Vector = System::Vector;      ///< unknowns

  /// Takes a matrix. \throws Convergence_error if it is singular.
  void factorize(System&& system, unsigned number_of_threads = 1) {
    static constexpr Eigen::Index small =
        2000; // unknowns, of 500 vertices: where both take as long
    m_is_direct = 3 * system.nodal.rows() + system.c.rows() <= small;
    if (m_is_direct)
      m_direct.factorize(std::move(system), number_of_threads);
    else
      m_iterative.factorize(std::move(system), number_of_threads);
  }

  /// Takes one like that of before, which may be made use of.
  void update(System&& system) {
    if (m_is_direct)
      m_direct.update(std::move(system));
    else
      m_iterative.update(std::move(system));
  }

  /// Solves for v and p, which hold a guess. Returns the number of iterations.
  /// \throws Convergence_error if they do not converge
  unsigned solve(const Vector& f, const Vector& s, Vector& v, Vector& p, double tolerance) {
    return m_is_direct ? m_direct.solve(f, s, v, p, tolerance)
                       : m_iterative.solve(f, s, v, p, tolerance);
  }

private:
  bool m_is_direct = true;
  Direct_saddle_point_solver m_direct;
  Iterative_saddle_point_solver m_iterative;
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_SADDLE_POINT_SOLVER_H
