// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_MINIMAL_RESIDUALS_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_MINIMAL_RESIDUALS_H

#include <CGAL/Incompressible_fluids_3/fluid_errors.h>
#include <CGAL/Incompressible_fluids_3/internal/solvers/blocks_of_vectors.h>
#include <CGAL/Mesh_support/For_each_index.h>
#include <CGAL/Mesh_support/Progress_scope.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The method of minimal residuals, see `minimal_residuals()`.
template <class Multiply, class Precondition> class Minimal_residual_method
{
public:
  using Vector = Eigen::VectorXd;

  Minimal_residual_method(const For_each_index& for_each, const Multiply& multiply,
                          const Precondition& precondition, const Vector& right, double tolerance)
      : m_for_each(for_each), m_multiply(multiply), m_precondition(precondition), m_right(right),
        m_least_bound((std::max)(tolerance, rounding)), m_size(right.size()), m_residual(right),
        m_r(m_size), m_r_before(m_size), m_z(m_size), m_q(m_size), m_next(m_size), m_w(m_size),
        m_w_before(m_size), m_correction(m_size) {
    m_norm_of_right = norm_of_residual();
    if (!std::isfinite(m_norm_of_right))
      throw Convergence_error("the equations of the flow are not finite: the time step may be too "
                              "short or too long, or cells may be flat",
                              infinite, m_least_bound);
    m_bound = tolerance * m_norm_of_right;
  }

  // Improves the solution until its true residual is below the bound. Returns the number of
  // iterations.
  unsigned solve(Vector& x) {
    if (m_right.isZero(0)) {
      x.setZero();
      return 0;
    }
    for (double last = infinite;;) {
      m_multiply(x, m_residual);
      m_residual = m_right - m_residual;
      const double residual = norm_of_residual();
      if (!std::isfinite(residual))
        throw_no_solution();
      if (residual <= m_bound)
        return m_iterations;
      if (residual > less * last) {
        if (residual <= m_least_bound * m_norm_of_right)
          return m_iterations;
        throw Convergence_error(
            "the iterative solver of the equations of the flow does not converge: the residual "
            "stagnates; cells may be too flat, or the time step may be too long",
            residual / m_norm_of_right, m_least_bound);
      }
      last = residual;
      iterate(residual / m_unit, m_bound / m_unit);
      x += m_unit * m_correction.cast<double>();
    }
  }

private:
  using Single_vector = Eigen::VectorXf;

  static constexpr double infinite = std::numeric_limits<double>::infinity();
  static constexpr double rounding = 1e-9; // relative to the right side
  // The recurrence is used up to this residual, relative to the residual at the last restart.
  static constexpr double trusted = 1e-5;
  // The method stagnates if a restart does not reduce the true residual by this factor.
  static constexpr double less = .5;
  static constexpr unsigned most = 3000; // iterations

  double dot(const Single_vector& a, const Single_vector& b) const {
    return sum_of_blocks(m_for_each, m_size, [&](Eigen::Index begin, Eigen::Index size) {
      return a.segment(begin, size).cast<double>().dot(b.segment(begin, size).cast<double>());
    });
  }

  static double norm(double square) { return std::sqrt((std::max)(0., square)); }

  // Converts the residual to single precision, in a unit in which its entries are near 1. Returns
  // its norm.
  double norm_of_residual() {
    m_unit = unit_of(m_residual.size() > 0 ? m_residual.lpNorm<Eigen::Infinity>() : 0);
    m_r = (m_residual / m_unit).cast<float>();
    m_precondition(m_r, m_z);
    const double square = dot(m_r, m_z);
    const bool is_solved = m_r.isZero(0);
    return square > 0 || is_solved ? m_unit * norm(square) : infinite;
  }

  // Solves for the correction until the residual of the recurrence is below the bound. The names
  // are those of Paige and Saunders. The vectors r are the Lanczos vectors, not normalized.
  void iterate(double beta, double bound) {
    const double enough = (std::max)(bound, trusted * beta);
    double beta_before = 1, eta = beta;
    double cosine = -1, sine = 0, epsilon = 0, delta_bar = 0;
    m_r_before.setZero();
    m_w.setZero();
    m_w_before.setZero();
    m_correction.setZero();
    while (std::abs(eta) > enough) {
      Progress_scope::check();
      if (++m_iterations > most)
        throw Convergence_error("the iterative solver of the equations of the flow does not "
                                "converge: cells may be too flat, or the time step may be too long",
                                m_unit * std::abs(eta) / m_norm_of_right, m_least_bound);
      const double alpha = next_lanczos_vector(beta, beta / beta_before);
      beta_before = beta;
      const double square = dot(m_r, m_z);
      if (std::isnan(square))
        throw_no_solution();
      beta = norm(square);
      const double epsilon_before = epsilon, delta = cosine * delta_bar + sine * alpha,
                   gamma_bar = sine * delta_bar - cosine * alpha;
      epsilon = sine * beta;
      delta_bar = -cosine * beta;
      const double gamma = std::hypot(gamma_bar, beta);
      cosine = gamma_bar / gamma;
      sine = beta / gamma;
      update_correction(float(epsilon_before), float(delta), float(gamma), float(cosine * eta));
      eta *= sine;
      if (!(beta > 0))
        break;
    }
  }

  // Replaces the Lanczos vectors, and returns alpha.
  double next_lanczos_vector(double beta, double back) {
    m_q = m_z / float(beta);
    m_multiply(m_q, m_next);
    const double alpha =
        sum_of_blocks(m_for_each, m_size, [&](Eigen::Index begin, Eigen::Index size) {
          auto part = m_next.segment(begin, size);
          part -= float(back) * m_r_before.segment(begin, size);
          return m_q.segment(begin, size).cast<double>().dot(part.template cast<double>());
        });
    m_r_before.swap(m_r);
    for_each_block(m_for_each, m_size, [&](Eigen::Index begin, Eigen::Index size) {
      m_r.segment(begin, size) =
          m_next.segment(begin, size) - float(alpha / beta) * m_r_before.segment(begin, size);
    });
    m_precondition(m_r, m_z);
    return alpha;
  }

  void update_correction(float epsilon, float delta, float gamma, float phi) {
    m_w_before.swap(m_w);
    for_each_block(m_for_each, m_size, [&](Eigen::Index begin, Eigen::Index size) {
      auto part = m_w.segment(begin, size);
      part = (m_q.segment(begin, size) - epsilon * part - delta * m_w_before.segment(begin, size)) /
             gamma;
      m_correction.segment(begin, size) += phi * part;
    });
  }

  [[noreturn]] void throw_no_solution() const {
    throw Convergence_error("the equations of the flow have no finite solution: cells may be too "
                            "flat",
                            infinite, m_least_bound);
  }

  const For_each_index& m_for_each;
  const Multiply& m_multiply;
  const Precondition& m_precondition;
  const Vector& m_right;
  double m_least_bound;
  Eigen::Index m_size;
  Vector m_residual; // the true one
  Single_vector m_r, m_r_before, m_z, m_q, m_next, m_w, m_w_before, m_correction;
  double m_unit, m_norm_of_right, m_bound;
  unsigned m_iterations = 0;
};

// Solves a symmetric system by the method of minimal residuals (C. C. Paige and M. A. Saunders,
// "Solution of sparse indefinite systems of linear equations", SIAM J. Numer. Anal. 12, 1975).
// Returns the number of iterations. The vector x is the initial guess and then the solution.
// `multiply(in, out)` applies the matrix, for vectors of either precision. `precondition(in, out)`
// applies a positive definite preconditioner in single precision. The norm of the preconditioner
// defines the residual, and `tolerance` is relative to the right side.
//
// The iterations use single precision, because they are limited by the memory. The method therefore
// restarts with the true residual, right - A x, in double precision. It ends only if the true
// residual is below the bound. Rounding can prevent convergence to the tolerance. If the method
// stagnates, a residual below `rounding` times the right side is also accepted.
//
// \pre the entries of the matrix and of the preconditioner are near 1, see `System_units`
// \throws Convergence_error if the true residual stays above these bounds, or if there is no finite
// solution
template <class Multiply, class Precondition>
unsigned minimal_residuals(const For_each_index& for_each, const Multiply& multiply,
                           const Precondition& precondition, const Eigen::VectorXd& right,
                           double tolerance, Eigen::VectorXd& x) {
  return Minimal_residual_method<Multiply, Precondition>(for_each, multiply, precondition, right,
                                                         tolerance)
      .solve(x);
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_MINIMAL_RESIDUALS_H
