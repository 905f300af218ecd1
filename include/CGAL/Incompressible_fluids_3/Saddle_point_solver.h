// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_SADDLE_POINT_SOLVER_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_SADDLE_POINT_SOLVER_H

#include <CGAL/Incompressible_fluids_3/Saddle_point_system.h>
#include <CGAL/Incompressible_fluids_3/fluid_errors.h>
#include <CGAL/Incompressible_fluids_3/internal/solvers/Multilevel_preconditioner.h>
#include <CGAL/Incompressible_fluids_3/internal/solvers/Saddle_point_operator.h>
#include <CGAL/Incompressible_fluids_3/internal/solvers/minimal_residuals.h>
#include <CGAL/Incompressible_fluids_3/internal/solvers/pressure_matrix.h>
#include <CGAL/Incompressible_fluids_3/internal/solvers/relative_residual.h>
#include <CGAL/Mesh_support/For_each_index.h>

#include <memory>
#include <optional>

namespace CGAL::Deformable_simplicial_complexes {
/*!
\ingroup PkgIncompressibleFluids3Ref

A direct solver of saddle point systems, by a sparse Cholesky factorization LDL^T. The factorization
exists for any order of the unknowns, because the matrix is quasi-definite (R. J. Vanderbei,
"Symmetric quasidefinite matrices", SIAM J. Optim. 5, 1995). It is fast for up to about five hundred
vertices.

\cgalModels{SaddlePointSolver}
*/
class Direct_saddle_point_solver
{
public:
  using System = Saddle_point_system; ///< the system to be solved
  using Vector = System::Vector;      ///< a vector of unknowns

  /// Factorizes the matrix of a system. For n unknowns in space, it takes about O(n^2) time and
  /// O(n^(4/3)) memory. It uses one thread.
  /// \throws Convergence_error if the matrix is singular
  void factorize(System&& system, unsigned number_of_threads = 1) {
    static_cast<void>(number_of_threads);
    m_system = std::move(system);
    // Constrained velocities do not affect other unknowns, and have arbitrary equations of their
    // own. The weighted mean of each closed set is an additional unknown, which keeps the matrix
    // sparse.
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
    if (!m_system.constrained.empty()) {
      Symmetric free(all, all), fixed(all, all);
      free.setIdentity();
      entries.clear();
      for (const auto& h : m_system.constrained)
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

  /// Replaces the system by a similar one, as `factorize()` does.
  void update(System&& system) { factorize(std::move(system)); }

  /// Solves for the velocities v and the pressures p. Returns the number of iterative refinements.
  /// \param f,s the right side
  /// \param v,p the solution; no initial guess is used
  /// \param tolerance the tolerance of the true residual, relative to its largest term. Values
  /// below 1e-8 are replaced by 1e-8.
  /// \throws Convergence_error if the solution is not finite, or if the residual is above the
  /// tolerance; then v and p are unchanged
  unsigned solve(const Vector& f, const Vector& s, Vector& v, Vector& p,
                 double tolerance = 0) const {
    // Each refinement reduces the error by the relative change of c.
    static constexpr unsigned refinements = 2;
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
                              "may be too short or too long, or cells may be flat",
                              residual, bound);
    v = velocities;
    p = pressures;
    return refinements;
  }

private:
  using Symmetric = Eigen::SparseMatrix<double>;

  // Calls `f(row, column, value)` for each entry of a matrix.
  template <class Function>
  static void for_each_entry(const System::Matrix& matrix, const Function& f) {
    for (Eigen::Index row = 0; row < matrix.rows(); ++row)
      for (System::Matrix::InnerIterator i(matrix, row); i; ++i)
        f(row, i.col(), i.value());
  }

  // The matrix c is only semidefinite, so its diagonal is multiplied by this factor.
  static constexpr double above_zero = 1 + 1e-8;

  System m_system;
  Eigen::SimplicialLDLT<Symmetric> m_solver;
  Symmetric m_whole; // the lower triangle
};

/*!
\ingroup PkgIncompressibleFluids3Ref

An iterative solver of saddle point systems, by the method of minimal residuals (C. C. Paige and
M. A. Saunders, "Solution of sparse indefinite systems of linear equations", SIAM J. Numer. Anal.
12, 1975). The preconditioner has two blocks (J. Cahouet and J.-P. Chabard, "Some fast 3D finite
element solvers for the generalized Stokes problem", Int. J. Numer. Methods Fluids 8, 1988):

- For velocities, it is an incomplete Cholesky factorization of the matrix `nodal`.
- For pressures, it is an approximate inverse of the Schur complement of the masses, plus a term of
  the viscosity. The inverse has several levels, so that the number of iterations is almost
  independent of the number of unknowns.

Memory and time are almost linear in the number of unknowns. The result is deterministic
and does not depend on the number of threads.

\cgalModels{SaddlePointSolver}
*/
class Iterative_saddle_point_solver
{
public:
  using System = Saddle_point_system; ///< the system to be solved
  using Vector = System::Vector;      ///< a vector of unknowns

  /// Computes the factorizations and the levels of a system. Takes about linear time.
  /// \throws Convergence_error if a factorization does not exist, because its matrix is not
  /// positive definite
  void factorize(System&& system, unsigned number_of_threads = 1) {
    m_for_each.emplace(number_of_threads);
    m_units = units_of(system);
    update(std::move(system));
    std::array<bool, 2> exists;
    (*m_for_each)(
        2,
        [&](std::size_t k) {
          exists[k] = k == 0 ? compute_pressure_preconditioner()
                             : m_of_velocities.compute(free_part(m_system) * m_units.of_nodal());
        },
        2);
    if (!exists[0] || !exists[1])
      internal::throw_singular_equations();
  }

  /// Replaces the system by a similar one, and keeps the factorizations. Takes linear time.
  void update(System&& system) {
    m_system = std::move(system);
    m_matrix = internal::Saddle_point_operator<double>(*m_for_each, m_system);
    m_single = internal::Saddle_point_operator<float>(*m_for_each, m_matrix, m_units);
  }

  /// Solves for the velocities v and the pressures p. Returns the number of iterations.
  /// \param f,s the right side
  /// \param v,p the initial guess, and then the solution
  /// \param tolerance the tolerance of the true residual, relative to the right side, in the norm
  /// of the preconditioner. If rounding prevents convergence to it, a residual of 1e-9 is accepted.
  /// \throws Convergence_error if the iterations do not converge; v is then projected, and p is
  /// unchanged
  unsigned solve(const Vector& f, const Vector& s, Vector& v, Vector& p, double tolerance) {
    const Eigen::Index n = f.size(), m = s.size();
    Vector x(n + m), right(n + m);
    m_system.project(v);
    x << v / m_units.velocity, p / m_units.pressure;
    right << f * (m_units.factor * m_units.velocity), -s * (m_units.factor * m_units.pressure);
    m_system.project(right);
    const unsigned result = internal::minimal_residuals(
        *m_for_each, [this](const auto& in, auto& out) { multiply(in, out); },
        [this](const auto& in, auto& out) { precondition(in, out); }, right, tolerance, x);
    v = x.head(n) * m_units.velocity;
    m_system.project(v);
    p = x.tail(m) * m_units.pressure;
    return result;
  }

private:
  using Single_vector = Eigen::VectorXf;

  // Returns the units in which the entries of the matrix are near 1.
  static internal::System_units units_of(const System& system) {
    const Vector velocities = system.nodal.diagonal();
    Vector pressures = system.c.diagonal();
    for (Eigen::Index p = 0; p < system.b.rows(); ++p)
      for (System::Matrix::InnerIterator k(system.b, p); k; ++k)
        pressures(p) += k.value() * k.value() / system.inertia(k.col() / 3);
    const auto largest = [](const Vector& diagonal) {
      return diagonal.size() > 0 ? diagonal.maxCoeff() : 0;
    };
    return internal::System_units::of(largest(velocities), largest(pressures));
  }

  bool compute_pressure_preconditioner() {
    const double square = m_units.of_c();
    m_viscosity = (m_system.viscosity / square).cast<float>();
    m_result.resize(m_viscosity.size());
    return m_of_pressures.compute(
        internal::pressure_matrix(*m_for_each, m_system, m_matrix, square),
        m_system.c.triangularView<Eigen::Lower>());
  }

  // Computes the products of the matrix and a vector, in the units.
  void multiply(const Vector& x, Vector& y) {
    const Eigen::Index n = 3 * m_system.nodal.rows(), m = m_system.c.rows();
    m_scaled.resize(n + m);
    m_scaled << x.head(n) * m_units.velocity, x.tail(m) * m_units.pressure;
    m_system.project(m_scaled); // corrections in single precision are not projected exactly
    m_matrix.multiply(*m_for_each, m_scaled, y);
    y.head(n) *= m_units.factor * m_units.velocity;
    y.tail(m) *= m_units.factor * m_units.pressure;
    complete_product(x, y);
  }
  void multiply(const Single_vector& x, Single_vector& y) {
    m_single.multiply(*m_for_each, x, y);
    complete_product(x, y);
  }

  // Adds the term of closed sets to a product, and projects it.
  template <class Values> void complete_product(const Values& x, Values& y) const {
    const double square = m_units.of_c();
    const Eigen::Index n = 3 * m_system.nodal.rows();
    for (const auto& set : m_system.closed)
      set.add(-square * set.weight * set.mean(x, n), y, n);
    m_system.project(y);
  }

  // Applies the preconditioner to a vector.
  void precondition(const Single_vector& x, Single_vector& y) {
    const Eigen::Index n = 3 * m_system.nodal.rows(), m = m_system.c.rows();
    const double square = m_units.of_c();
    (*m_for_each)(
        2,
        [&](std::size_t k) {
          if (k == 0) {
            m_pressures = x.tail(m);
            remove_means(m_pressures);
            m_of_pressures.solve(m_pressures, m_result);
            m_result += m_viscosity.cwiseProduct(m_pressures);
            remove_means(m_result);
            y.tail(m) = m_result;
            for (const auto& set : m_system.closed)
              set.add(set.mean(x, n) / (square * set.weight), y, n);
          } else
            m_of_velocities.solve(x.head(n), y.head(n));
        },
        2);
    m_system.project(y);
  }

  // Removes the means of closed sets. The preconditioner scales these means separately.
  void remove_means(Single_vector& pressures) const {
    for (const auto& set : m_system.closed)
      set.add(-set.mean(pressures), pressures);
  }

  // Returns the lower triangle of the matrix `nodal`. Entries that couple a vertex without any free
  // velocity to others are removed.
  static Eigen::SparseMatrix<double> free_part(const System& system) {
    std::vector<char> is_fixed(std::size_t(system.nodal.rows()), false);
    for (const auto& h : system.constrained)
      is_fixed[std::size_t(h.vertex)] = h.projection.isZero();
    Eigen::SparseMatrix<double> result = system.nodal.triangularView<Eigen::Lower>();
    result.prune([&](Eigen::Index i, Eigen::Index j, double) {
      return i == j || !(is_fixed[std::size_t(i)] || is_fixed[std::size_t(j)]);
    });
    return result;
  }

  System m_system;
  internal::System_units m_units;
  internal::Saddle_point_operator<double> m_matrix;
  internal::Saddle_point_operator<float> m_single; // in the units
  internal::Incomplete_factorization<3> m_of_velocities;
  internal::Multilevel_preconditioner m_of_pressures;
  Single_vector m_viscosity, m_pressures, m_result;
  Vector m_scaled;
  std::optional<For_each_index> m_for_each;
};

/*!
\ingroup PkgIncompressibleFluids3Ref

The default solver of saddle point systems. It solves systems with at most 2000 unknowns directly,
and larger systems iteratively. Another solver can replace both at run time.

\cgalModels{SaddlePointSolver}
*/
class Saddle_point_solver
{
public:
  using System = Saddle_point_system; ///< the system to be solved
  using Vector = System::Vector;      ///< a vector of unknowns

  /// Uses another solver instead, for systems of any size. Call `factorize()` next.
  /// \tparam Model a model of `SaddlePointSolver`
  /// \param arguments the arguments of the constructor of `Model`
  template <class Model, class... Arguments> void use(Arguments&&... arguments) {
    m_other = std::make_unique<Other_solver<Model>>(std::forward<Arguments>(arguments)...);
  }

  /// Factorizes the matrix of a system.
  /// \throws Convergence_error if the matrix is singular
  void factorize(System&& system, unsigned number_of_threads = 1) {
    if (m_other) {
      m_other->factorize(std::move(system), number_of_threads);
      return;
    }
    // In unknowns, which are about 500 vertices. For this size, both solvers take the same time.
    static constexpr Eigen::Index small_system = 2000;
    m_is_direct = 3 * system.nodal.rows() + system.c.rows() <= small_system;
    if (m_is_direct)
      m_direct.factorize(std::move(system), number_of_threads);
    else
      m_iterative.factorize(std::move(system), number_of_threads);
  }

  /// Replaces the system by a similar one. The iterative solver keeps its factorizations.
  /// \throws Convergence_error if the matrix is singular and the solver is direct
  void update(System&& system) {
    if (m_other)
      m_other->update(std::move(system));
    else if (m_is_direct)
      m_direct.update(std::move(system));
    else
      m_iterative.update(std::move(system));
  }

  /// Solves for the velocities v and the pressures p. Returns the number of iterations.
  /// \param f,s the right side
  /// \param v,p the initial guess, and then the solution
  /// \param tolerance the tolerance of the true residual, see the two solvers
  /// \throws Convergence_error if the solver does not converge
  unsigned solve(const Vector& f, const Vector& s, Vector& v, Vector& p, double tolerance) {
    return m_other       ? m_other->solve(f, s, v, p, tolerance)
           : m_is_direct ? m_direct.solve(f, s, v, p, tolerance)
                         : m_iterative.solve(f, s, v, p, tolerance);
  }

private:
  // A solver whose type is erased.
  struct Other
  {
    virtual ~Other() = default;
    virtual void factorize(System&& system, unsigned number_of_threads) = 0;
    virtual void update(System&& system) = 0;
    virtual unsigned solve(const Vector& f, const Vector& s, Vector& v, Vector& p,
                           double tolerance) = 0;
  };

  template <class Model> struct Other_solver : Other
  {
    template <class... Arguments>
    explicit Other_solver(Arguments&&... arguments)
        : m_model(std::forward<Arguments>(arguments)...) {}
    void factorize(System&& system, unsigned number_of_threads) override {
      m_model.factorize(std::move(system), number_of_threads);
    }
    void update(System&& system) override { m_model.update(std::move(system)); }
    unsigned solve(const Vector& f, const Vector& s, Vector& v, Vector& p,
                   double tolerance) override {
      return m_model.solve(f, s, v, p, tolerance);
    }

    Model m_model;
  };

  bool m_is_direct = true;
  Direct_saddle_point_solver m_direct;
  Iterative_saddle_point_solver m_iterative;
  std::unique_ptr<Other> m_other; // null unless the other two are replaced
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_SADDLE_POINT_SOLVER_H
