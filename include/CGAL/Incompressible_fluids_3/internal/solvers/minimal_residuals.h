// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Incompressible_fluids_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_MINIMAL_RESIDUALS_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_MINIMAL_RESIDUALS_H

#include <CGAL/Deformable_simplicial_complexes/For_each_index.h>
#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>
#include <CGAL/Incompressible_fluids_3/fluid_errors.h>
#include <CGAL/Incompressible_fluids_3/internal/solvers/unit_of.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

constexpr Eigen::Index block_size = 8192; // entries; a block fits into the cache

// Returns the number of blocks of n entries.
inline std::size_t number_of_blocks(Eigen::Index n) {
  return std::size_t((n + block_size - 1) / block_size);
}

// Calls `f(begin, size)` for each block of n entries. The blocks do not depend on the number of
// threads.
template <class Function>
void for_each_block(const For_each_index& for_each, Eigen::Index n, const Function& f) {
  for_each(
      number_of_blocks(n),
      [&](std::size_t k) {
        const Eigen::Index begin = Eigen::Index(k) * block_size;
        f(begin, (std::min)(block_size, n - begin));
      },
      2);
}

// Returns the sum of `f(begin, size)` over all blocks. The result is bitwise reproducible.
template <class Function>
double sum_of_blocks(const For_each_index& for_each, Eigen::Index n, const Function& f) {
  std::vector<double> parts(number_of_blocks(n));
  for_each_block(for_each, n, [&](Eigen::Index begin, Eigen::Index size) {
    parts[std::size_t(begin / block_size)] = f(begin, size);
  });
  return std::accumulate(parts.begin(), parts.end(), 0.);
}

// Solves a symmetric system by the method of minimal residuals (C. C. Paige and M. A. Saunders,
// "Solution of sparse indefinite systems of linear equations", SIAM J. Numer. Anal. 12, 1975).
// Returns the number of iterations. The vector x is the initial guess and then the solution.
// `multiply(in, out)` applies the matrix, and `precondition(in, out)` applies a positive definite
// preconditioner. The norm of the preconditioner defines the residual, and `tolerance` is relative
// to the right side.
//
// The preconditioner may use single precision, so the residual of the recurrence is accurate to
// some digits only. The method therefore restarts with the true residual, right - A x. It ends only
// if the true residual is below the bound. Rounding can prevent convergence to the tolerance. If
// the method stagnates, a residual below `rounding` times the right side is also accepted.
// \throws Convergence_error if the true residual stays above these bounds, or if there is no finite
// solution
template <class Multiply, class Precondition>
unsigned minimal_residuals(const For_each_index& for_each, const Multiply& multiply,
                           const Precondition& precondition, const Eigen::VectorXd& right,
                           double tolerance, Eigen::VectorXd& x) {
  using Vector = Eigen::VectorXd;
  static constexpr unsigned most = 3000;
  static constexpr double trusted =
      1e-5; // bound of the recurrence, relative to the residual at the last restart
  static constexpr double less = .5; // than the last true residual, otherwise the method stagnates
  static constexpr double rounding = 1e-9; // relative to the right side
  const Eigen::Index n = right.size();
  const auto dot = [&](const Vector& a, const Vector& b) {
    return sum_of_blocks(for_each, n, [&](Eigen::Index begin, Eigen::Index size) {
      return a.segment(begin, size).dot(b.segment(begin, size));
    });
  };
  Vector z(n), q(n), next(n), w(n), w_before(n);
  precondition(right, z);
  const double square_of_right = dot(right, z), unit = unit_of(square_of_right);
  const auto norm = [&](double square) { return std::sqrt((std::max)(0., square / unit)); };
  const double size = norm(square_of_right), bound = tolerance * size,
               least_bound = (std::max)(tolerance, rounding);
  static constexpr double infinite = std::numeric_limits<double>::infinity();
  if (!std::isfinite(square_of_right))
    throw Convergence_error("the equations of the flow are not finite: the time step may be too "
                            "short or too long for numbers, or cells flat",
                            infinite, least_bound);
  if (size == 0) {
    x.setZero();
    return 0;
  }
  Vector r(n), r_before(n);
  unsigned k = 0;
  for (double last = infinite;;) {
    multiply(x, next);
    r = right - next;
    precondition(r, z);
    const double square_of_residual = dot(r, z);
    if (!std::isfinite(square_of_residual))
      throw Convergence_error("the equations of the flow have no finite solution: cells may be too "
                              "flat",
                              infinite, least_bound);
    double beta = norm(square_of_residual), beta_before = 1, eta = beta;
    if (beta <= bound)
      return k;
    if (beta > less * last) {
      if (beta <= least_bound * size)
        return k;
      throw Convergence_error("the equations of the flow cannot be solved by iterations: the "
                              "residual stagnates; cells may be too flat, or the time step too "
                              "long",
                              beta / size, least_bound);
    }
    last = beta;
    const double enough = (std::max)(bound, trusted * beta);
    double cosine = -1, sine = 0, epsilon = 0, delta_bar = 0;
    r_before.setZero();
    w.setZero();
    w_before.setZero();
    // The names are those of Paige and Saunders. The vectors r are the Lanczos vectors, not
    // normalized.
    while (!(std::abs(eta) <= enough)) { // the negation also ends the loop for NaN
      Progress_scope::check();
      if (++k > most)
        throw Convergence_error("the equations of the flow cannot be solved by iterations: cells "
                                "may be too flat, or the time step too long",
                                std::abs(eta) / size, least_bound);
      q = z / (unit * beta);
      multiply(q, next);
      const double back = beta / beta_before;
      const double alpha = sum_of_blocks(for_each, n, [&](Eigen::Index begin, Eigen::Index size) {
        auto part = next.segment(begin, size);
        part -= back * r_before.segment(begin, size);
        return q.segment(begin, size).dot(part);
      });
      r_before.swap(r);
      for_each_block(for_each, n, [&](Eigen::Index begin, Eigen::Index size) {
        r.segment(begin, size) =
            next.segment(begin, size) - alpha / beta * r_before.segment(begin, size);
      });
      precondition(r, z);
      beta_before = beta;
      const double square = dot(r, z);
      if (std::isnan(square))
        throw Convergence_error(
            "the equations of the flow have no finite solution: cells may be too flat", infinite,
            least_bound);
      beta = norm(square);
      const double epsilon_before = epsilon, delta = cosine * delta_bar + sine * alpha,
                   gamma_bar = sine * delta_bar - cosine * alpha;
      epsilon = sine * beta;
      delta_bar = -cosine * beta;
      const double gamma = std::hypot(gamma_bar, beta);
      cosine = gamma_bar / gamma;
      sine = beta / gamma;
      const double phi = cosine * eta;
      eta *= sine;
      w_before.swap(w);
      for_each_block(for_each, n, [&](Eigen::Index begin, Eigen::Index size) {
        auto part = w.segment(begin, size);
        part = (q.segment(begin, size) - epsilon_before * part -
                delta * w_before.segment(begin, size)) /
               gamma;
        x.segment(begin, size) += phi * part;
      });
      if (!(beta > 0))
        break;
    }
  }
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_MINIMAL_RESIDUALS_H
