// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_SADDLE_POINT_SOLVER_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_SADDLE_POINT_SOLVER_H

#include <CGAL/Deformable_simplicial_complexes/exceptions.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

The matrix of a linear system of `Incompressible_fluid_3`,

    (  a  -b^T ) (v)   ( f)
    ( -b  -c   ) (p) = (-s),

symmetric, `a` positive definite and `c` positive semidefinite; and what tells about its nature.
*/
struct Saddle_point_system
{
  using Matrix = Eigen::SparseMatrix<double>; ///< stored by columns
  using Vector = Eigen::VectorXd;             ///< dense

  Matrix a;         ///< of velocities: masses over time, viscosity and surface tension
  Matrix b;         ///< the gradients of volumes, a row for each pressure
  Matrix c;         ///< of pressures
  Vector inertia;   ///< about the diagonal of `a` without the part of viscosity: of masses, sums of
                    ///< rows
  Vector viscosity; ///< for each pressure the viscosity over a quarter of the volume around
};

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Solves saddle point systems by a sparse Cholesky factorization LDL^T, which exists for any order of
the unknowns, as the matrix is quasi-definite (R. J. Vanderbei, "Symmetric quasidefinite matrices",
SIAM J. Optim. 5, 1995). To be preferred up to about a thousand vertices.

\cgalModels `SaddlePointSolver`
*/
class Direct_saddle_point_solver
{
public:
  using System = Saddle_point_system; ///< what is solved
  using Vector = System::Vector;      ///< unknowns

  /// Takes a matrix. \throws Error if it is singular, other than for pressures that are constant.
  /// About n^2 for n unknowns in space, and memory of n^(4/3).
  void factorize(System&& system) {
    using Iterator = System::Matrix::InnerIterator;
    std::vector<Eigen::Triplet<double>> entries; // of the lower triangle
    const auto n = system.a.rows();
    for (Eigen::Index j = 0; j < n; ++j) {
      for (Iterator i(system.a, j); i; ++i)
        if (i.row() >= j)
          entries.emplace_back(i.row(), j, i.value());
      for (Iterator i(system.b, j); i; ++i)
        entries.emplace_back(n + i.row(), j, -i.value());
    }
    for (Eigen::Index j = 0; j < system.c.cols(); ++j)
      for (Iterator i(system.c, j); i; ++i)
        if (i.row() >= j)
          entries.emplace_back(n + i.row(), n + j, -i.value());
    m_whole = System::Matrix(n + system.c.rows(), n + system.c.rows());
    m_whole.setFromTriplets(entries.begin(), entries.end());
    System::Matrix definite = m_whole;
    definite.diagonal().tail(system.c.rows()) *= above_zero;
    m_solver.compute(definite);
    if (m_solver.info() != Eigen::Success)
      throw Error("the equations of the flow are singular: a liquid may have no free surface and "
                  "nothing that holds its pressure, or cells may be flat");
  }

  /// Solves for v and p. Returns how often it had to be refined.
  /// \throws Error if the solution is not finite
  unsigned solve(const Vector& f, const Vector& s, Vector& v, Vector& p) const {
    static constexpr unsigned refinements = 2; // each is nearer by what c was changed by
    Vector right(f.size() + s.size());
    right << f, -s;
    Vector x = m_solver.solve(right);
    for (unsigned k = 0; k < refinements; ++k)
      x += m_solver.solve(right - m_whole.selfadjointView<Eigen::Lower>() * x);
    if (!x.allFinite())
      throw Error("the equations of the flow have no finite solution: the step may be too short or "
                  "too long for numbers, or cells flat");
    v = x.head(f.size());
    p = x.tail(s.size());
    return refinements;
  }

private:
  // Where no surface is free, pressures may all grow by the same.
  static constexpr double above_zero = 1 + 1e-8;

  Eigen::SimplicialLDLT<System::Matrix> m_solver;
  System::Matrix m_whole; // lower triangle
};

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Solves saddle point systems by the method of minimal residuals (C. C. Paige and M. A. Saunders,
"Solution of sparse indefinite systems of linear equations", SIAM J. Numer. Anal. 12, 1975), for
velocities preconditioned by an incomplete Cholesky factorization, for pressures by that of what
masses make of them, and by viscosity (J. Cahouet and J.-P. Chabard, "Some fast 3D finite element
solvers for the generalized Stokes problem", Int. J. Numer. Methods Fluids 8, 1988). Memory is
linear in the number of unknowns, time almost.

\cgalModels `SaddlePointSolver`
*/
class Iterative_saddle_point_solver
{
public:
  using System = Saddle_point_system; ///< what is solved
  using Vector = System::Vector;      ///< unknowns

  /// \param tolerance of the residual, relative to that of the right side
  /// \throws Error if it is not between 0 and 1
  explicit Iterative_saddle_point_solver(double tolerance = 1e-12) : m_tolerance(tolerance) {
    if (!(tolerance > 0 && tolerance < 1))
      throw Error("the tolerance of a solver is out of range: use more than 0 and less than 1");
  }

  /// Takes a matrix. \throws Error if it is not definite where it should be.
  void factorize(System&& system) {
    m_system = std::move(system);
    m_bt = m_system.b.transpose();
    m_of_velocities.compute(m_system.a);
    System::Matrix schur =
        m_system.b * m_system.inertia.cwiseInverse().asDiagonal() * m_bt + m_system.c;
    schur.diagonal() *= above_zero;
    m_of_pressures.compute(schur);
    if (m_of_velocities.info() != Eigen::Success || m_of_pressures.info() != Eigen::Success)
      throw Error("the equations of the flow are singular: cells may be flat");
  }

  /// Solves for v and p, which hold a guess. Returns the number of iterations.
  /// \throws Error if they do not converge
  unsigned solve(const Vector& f, const Vector& s, Vector& v, Vector& p) const {
    static constexpr unsigned most = 3000;
    const Eigen::Index n = f.size(), m = s.size();
    Vector x(n + m), right(n + m);
    x << v, p;
    right << f, -s;
    const double bound = m_tolerance * std::sqrt(right.dot(precondition(right)));
    Vector r = right - multiply(x), r_before = r;
    Vector z = precondition(r), w(Vector::Zero(n + m)), w_before = w;
    double beta = std::sqrt(r.dot(z)), beta_before = 0, eta = beta;
    double cosine = -1, sine = 0, epsilon = 0, delta_bar = 0;
    unsigned k = 0;
    // By the names of Paige and Saunders: r are Lanczos' vectors, not normalized.
    while (!(std::abs(eta) <= bound)) { // nor for what is no number
      if (++k > most)
        throw Error("the equations of the flow cannot be solved by iterations: cells may be too "
                    "flat, or the step too long");
      const Vector q = z / beta;
      Vector next = multiply(q);
      if (k > 1)
        next -= beta / beta_before * r_before;
      const double alpha = q.dot(next);
      next -= alpha / beta * r;
      r_before.swap(r);
      r.swap(next);
      z = precondition(r);
      beta_before = beta;
      beta = std::sqrt((std::max)(0., r.dot(z)));
      const double epsilon_before = epsilon, delta = cosine * delta_bar + sine * alpha,
                   gamma_bar = sine * delta_bar - cosine * alpha;
      epsilon = sine * beta;
      delta_bar = -cosine * beta;
      const double gamma = std::hypot(gamma_bar, beta);
      cosine = gamma_bar / gamma;
      sine = beta / gamma;
      const double phi = cosine * eta;
      eta *= sine;
      Vector w_next = (q - epsilon_before * w_before - delta * w) / gamma;
      w_before.swap(w);
      w.swap(w_next);
      x += phi * w;
      if (!(beta > 0))
        break;
    }
    v = x.head(n);
    p = x.tail(m);
    return k;
  }

private:
  Vector multiply(const Vector& x) const {
    const Eigen::Index n = m_system.a.rows(), m = m_system.c.rows();
    Vector result(n + m);
    result.head(n) = m_system.a * x.head(n) - m_bt * x.tail(m);
    result.tail(m) = -(m_system.b * x.head(n)) - m_system.c * x.tail(m);
    return result;
  }

  Vector precondition(const Vector& x) const {
    const Eigen::Index n = m_system.a.rows(), m = m_system.c.rows();
    Vector result(n + m);
    result.head(n) = m_of_velocities.solve(x.head(n));
    result.tail(m) = m_of_pressures.solve(x.tail(m)) + m_system.viscosity.cwiseProduct(x.tail(m));
    return result;
  }

  // Where no surface is free, pressures may all grow by the same.
  static constexpr double above_zero = 1 + 1e-9;

  using Incomplete_factorization =
      Eigen::IncompleteCholesky<double, Eigen::Lower, Eigen::AMDOrdering<int>>;

  double m_tolerance;
  System m_system;
  System::Matrix m_bt; // of b
  Incomplete_factorization m_of_velocities, m_of_pressures;
};

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Solves small saddle point systems directly, others by iterations: whichever takes less time.

\cgalModels `SaddlePointSolver`
*/
class Saddle_point_solver
{
public:
  using System = Saddle_point_system; ///< what is solved
  using Vector = System::Vector;      ///< unknowns

  /// Takes a matrix. \throws Error if it is singular.
  void factorize(System&& system) {
    static constexpr Eigen::Index small =
        2000; // unknowns, of 500 vertices: where both take as long
    m_is_direct = system.a.rows() + system.c.rows() <= small;
    if (m_is_direct)
      m_direct.factorize(std::move(system));
    else
      m_iterative.factorize(std::move(system));
  }

  /// Solves for v and p, which hold a guess. Returns the number of iterations.
  /// \throws Error if they do not converge
  unsigned solve(const Vector& f, const Vector& s, Vector& v, Vector& p) const {
    return m_is_direct ? m_direct.solve(f, s, v, p) : m_iterative.solve(f, s, v, p);
  }

private:
  bool m_is_direct = true;
  Direct_saddle_point_solver m_direct;
  Iterative_saddle_point_solver m_iterative;
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_SADDLE_POINT_SOLVER_H
