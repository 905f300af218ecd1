// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_MULTILEVEL_PRECONDITIONER_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_MULTILEVEL_PRECONDITIONER_H

#include <Eigen/Core>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <list>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// An approximation of the inverse of a symmetric positive definite matrix, by incomplete Cholesky
// factorization. It is a preconditioner, for one or several right sides at once. It uses single
// precision, because a preconditioner need not be exact. Entries of the matrix are near 1.
template <int columns> class Incomplete_factorization
{
public:
  using Matrix = Eigen::SparseMatrix<double>; // its lower triangle
  using Vector = Eigen::VectorXf;

  // Computes the factorization. Returns whether it exists.
  bool compute(const Matrix& lower) {
    const Eigen::VectorXd scale = lower.diagonal().cwiseSqrt().cwiseInverse();
    if (!scale.allFinite())
      return false;
    const Eigen::SparseMatrix<float> scaled =
        (scale.asDiagonal() * lower * scale.asDiagonal()).cast<float>();
    m_factorization.compute(scaled);
    if (m_factorization.info() != Eigen::Success)
      return false;
    m_scale = scale.cast<float>().cwiseProduct(m_factorization.scalingS());
    m_values.resize(columns, m_scale.size());
    return true;
  }

  // Applies the approximate inverse to `columns` numbers for each row. Only one thread at a time
  // can call it.
  template <class In, class Out> void solve(const In& in, Out&& out) {
    const auto& l = m_factorization.matrixL();
    const Eigen::Index n = m_scale.size();
    const auto* begin = l.outerIndexPtr();
    const auto* row = l.innerIndexPtr();
    const float* value = l.valuePtr();
    for (Eigen::Index i = 0; i < n; ++i)
      m_values.col(i) = m_scale(i) * in.template segment<columns>(columns * i);
    for (Eigen::Index j = 0; j < n; ++j) { // the first entry of a column is the diagonal
      const Column x = m_values.col(j) /= value[begin[j]];
      for (auto k = begin[j] + 1; k < begin[j + 1]; ++k)
        m_values.col(row[k]) -= value[k] * x;
    }
    for (Eigen::Index j = n - 1; j >= 0; --j) {
      Column x = m_values.col(j);
      for (auto k = begin[j] + 1; k < begin[j + 1]; ++k)
        x -= value[k] * m_values.col(row[k]);
      m_values.col(j) = x / value[begin[j]];
    }
    for (Eigen::Index i = 0; i < n; ++i)
      out.template segment<columns>(columns * i) = m_scale(i) * m_values.col(i);
  }

private:
  using Column = Eigen::Matrix<float, columns, 1>;

  Vector m_scale;
  Eigen::IncompleteCholesky<float, Eigen::Lower, Eigen::NaturalOrdering<int>> m_factorization;
  Eigen::Matrix<float, columns, Eigen::Dynamic> m_values;
};

// A partition of the unknowns of a matrix into aggregates.
struct Aggregates
{
  Eigen::Index number = 0;
  std::vector<Eigen::Index> of_unknown;
};

// Returns the strong entries of a symmetric matrix that is given by its lower triangle. Strong
// entries outside of the diagonal are negative, and at least `strong` times the most negative entry
// of their row or of their column.
inline Eigen::SparseMatrix<double> strong_entries(const Eigen::SparseMatrix<double>& lower,
                                                  double strong) {
  Eigen::SparseMatrix<double> result = lower.selfadjointView<Eigen::Lower>();
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(result.cols());
  for (Eigen::Index j = 0; j < result.cols(); ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator k(result, j); k; ++k)
      if (k.row() != j)
        largest(j) = (std::max)(largest(j), -k.value());
  result.prune([&](Eigen::Index i, Eigen::Index j, double value) {
    return i == j || (value < 0 && -value >= strong * (std::min)(largest(i), largest(j)));
  });
  return result;
}

// Returns aggregates of the graph of a symmetric matrix (P. Vanek, J. Mandel and M. Brezina,
// "Algebraic multigrid by smoothed aggregation for second and fourth order elliptic problems",
// Computing 56, 1996). First, each unknown without a neighbor in an aggregate founds an aggregate
// with all its neighbors. Then, the other unknowns join the aggregate of their nearest neighbor, by
// the size of the entry. Takes linear time.
inline Aggregates aggregates(const Eigen::SparseMatrix<double>& graph) {
  static constexpr Eigen::Index none = -1;
  using Entry = Eigen::SparseMatrix<double>::InnerIterator;
  const Eigen::Index n = graph.cols();
  Aggregates result;
  std::vector<Eigen::Index>& of = result.of_unknown;
  of.assign(std::size_t(n), none);
  for (Eigen::Index i = 0; i < n; ++i) {
    bool is_free = true;
    for (Entry k(graph, i); k && is_free; ++k)
      is_free = of[std::size_t(k.row())] == none;
    if (!is_free)
      continue;
    of[std::size_t(i)] = result.number;
    for (Entry k(graph, i); k; ++k)
      of[std::size_t(k.row())] = result.number;
    ++result.number;
  }
  const std::vector<Eigen::Index> founded = of;
  for (Eigen::Index i = 0; i < n; ++i) {
    if (of[std::size_t(i)] != none)
      continue;
    double largest = 0;
    for (Entry k(graph, i); k; ++k)
      if (founded[std::size_t(k.row())] != none && std::abs(k.value()) > largest) {
        largest = std::abs(k.value());
        of[std::size_t(i)] = founded[std::size_t(k.row())];
      }
    if (of[std::size_t(i)] == none)
      of[std::size_t(i)] = result.number++;
  }
  return result;
}

// Returns the lower triangle of the matrix between aggregates: its entries are sums of the entries
// between their unknowns. The matrix is symmetric and given by its lower triangle.
inline Eigen::SparseMatrix<double> matrix_of_aggregates(const Eigen::SparseMatrix<double>& lower,
                                                        const Aggregates& aggregates) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(std::size_t(lower.nonZeros()));
  for (Eigen::Index j = 0; j < lower.cols(); ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator k(lower, j); k; ++k) {
      const auto [least, greatest] = std::minmax(aggregates.of_unknown[std::size_t(k.row())],
                                                 aggregates.of_unknown[std::size_t(j)]);
      const bool stands_for_two = k.row() != j && least == greatest;
      entries.emplace_back(greatest, least, stands_for_two ? 2 * k.value() : k.value());
    }
  Eigen::SparseMatrix<double> result(aggregates.number, aggregates.number);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

// Returns the lower triangle of the near part of a symmetric matrix: the entries with the pattern
// of `near`. Positive sums of the other entries of a row are added to the diagonal, or with
// `is_safe`, the sums of their absolute values. The result is then positive definite if the matrix
// is. Both matrices are given by their lower triangles, with sorted entries.
inline Eigen::SparseMatrix<double> near_part(const Eigen::SparseMatrix<double>& lower,
                                             const Eigen::SparseMatrix<double>& nearby,
                                             bool is_safe) {
  using Entry = Eigen::SparseMatrix<double>::InnerIterator;
  Eigen::SparseMatrix<double> result = nearby;
  Eigen::VectorXd distant = Eigen::VectorXd::Zero(lower.cols());
  for (Eigen::Index j = 0; j < lower.cols(); ++j) {
    Entry to(result, j);
    for (Entry from(lower, j); from; ++from) {
      for (; to && to.row() < from.row(); ++to)
        to.valueRef() = 0;
      if (to && to.row() == from.row()) {
        to.valueRef() = from.value();
        ++to;
      } else {
        const double value = is_safe ? std::abs(from.value()) : from.value();
        distant(from.row()) += value;
        distant(j) += value;
      }
    }
    for (; to; ++to)
      to.valueRef() = 0;
  }
  result.diagonal() += distant.cwiseMax(0.);
  return result;
}

// An approximation of the inverse of a symmetric positive definite matrix. It is the mean of two
// parts:
//
// - For short waves, an incomplete factorization of the near part of the matrix.
// - For long waves, the matrix between aggregates of unknowns, see `aggregates()`. It is solved by
//   one V-cycle with incomplete factorizations as smoothers, and directly on the coarsest level.
//
// Vectors have single precision, so the entries of the matrix must be near 1.
//
// The number of iterations of a solver is nearly independent of the number of unknowns. The sum
// of the two parts needs no product with the matrix, whose rows can be long.
class Multilevel_preconditioner
{
public:
  using Matrix = Eigen::SparseMatrix<double>; // the lower triangle of a symmetric matrix
  using Vector = Eigen::VectorXf;

  // Computes the levels of a matrix. The near part has the pattern of the matrix `near`. Returns
  // whether all factorizations exist. Takes about linear time.
  bool compute(const Matrix& matrix, const Matrix& nearby) {
    const Matrix near_matrix = near_part(matrix, nearby, false);
    m_aggregates = aggregates(near_matrix.selfadjointView<Eigen::Lower>());
    m_coarse_in.resize(m_aggregates.number);
    m_coarse_out.resize(m_aggregates.number);
    return (m_of_near_part.compute(near_matrix) ||
            m_of_near_part.compute(near_part(matrix, nearby, true))) &&
           compute_levels(matrix_of_aggregates(matrix, m_aggregates));
  }

  // Applies the approximate inverse. Only one thread at a time can call it.
  void solve(const Vector& in, Vector& out) {
    m_of_near_part.solve(in, out);
    restrict(m_aggregates, in, m_coarse_in);
    cycle(m_levels.begin(), m_coarse_in, m_coarse_out);
    add_prolongation(m_aggregates, m_coarse_out, out);
    out *= .5;
  }

private:
  struct Level
  {
    Eigen::SparseMatrix<float> matrix; // both triangles
    Incomplete_factorization<1> smoother;
    float damping; // of the smoother
    Aggregates aggregates;
    Vector residual, correction, coarse_in, coarse_out;
  };
  using Levels = std::list<Level>;

  bool compute_levels(Matrix lower) {
    // Of neighbors, see `strong_entries()`. With smaller values, aggregates are too large.
    static constexpr double strong = .25;
    static constexpr Eigen::Index small_system = 200; // unknowns; a direct solution takes no time
    m_levels.clear();
    while (lower.cols() > small_system) {
      Aggregates of_level = aggregates(strong_entries(lower, strong));
      if (of_level.number == lower.cols()) // no unknown is coupled to another one
        break;
      Level& level = m_levels.emplace_back();
      level.aggregates = std::move(of_level);
      if (!level.smoother.compute(lower))
        return false;
      level.matrix = Matrix(lower.selfadjointView<Eigen::Lower>()).cast<float>();
      level.damping = damping(level);
      level.residual.resize(lower.cols());
      level.correction.resize(lower.cols());
      level.coarse_in.resize(level.aggregates.number);
      level.coarse_out.resize(level.aggregates.number);
      lower = matrix_of_aggregates(lower, level.aggregates);
    }
    // The matrix is singular up to rounding if a constant vector has no effect.
    static constexpr double above_zero = 1 + 1e-8;
    lower.diagonal() *= above_zero;
    m_of_coarsest.compute(lower);
    return m_of_coarsest.info() == Eigen::Success;
  }

  // Applies a V-cycle that begins at a level.
  void cycle(Levels::iterator at, const Vector& in, Vector& out) {
    if (at == m_levels.end()) {
      out = m_of_coarsest.solve(in.cast<double>()).cast<float>();
      return;
    }
    Level& level = *at;
    level.smoother.solve(in, out);
    out *= level.damping;
    level.residual = in - level.matrix * out;
    restrict(level.aggregates, level.residual, level.coarse_in);
    cycle(std::next(at), level.coarse_in, level.coarse_out);
    add_prolongation(level.aggregates, level.coarse_out, out);
    level.residual = in - level.matrix * out;
    level.smoother.solve(level.residual, level.correction);
    out += level.damping * level.correction;
  }

  // Returns a factor with which the smoother of a level reduces errors. The V-cycle is positive
  // definite only if all eigenvalues of the damped smoother, applied to the matrix, are less
  // than 2. An incomplete factorization of a matrix with positive entries off the diagonal can have
  // larger ones. The power method estimates the largest eigenvalue, always too small.
  static float damping(Level& level) {
    static constexpr int iterations = 12;
    static constexpr double largest = 1.5; // less than 2 because of the error of the estimate
    Vector x(level.matrix.cols()), y;
    for (Eigen::Index i = 0; i < x.size(); ++i) // no eigenvector is perpendicular to it in practice
      x(i) = float(std::uint32_t(i) * 2654435761u >> 22) / 1024 - .5f;
    double eigenvalue = 0;
    for (int k = 0; k < iterations; ++k) {
      x /= x.norm();
      y = level.matrix * x;
      level.smoother.solve(y, x);
      eigenvalue = x.norm();
    }
    return eigenvalue > largest ? float(largest / eigenvalue) : 1;
  }

  static void restrict(const Aggregates& aggregates, const Vector& fine, Vector& coarse) {
    coarse.setZero();
    for (Eigen::Index i = 0; i < fine.size(); ++i)
      coarse(aggregates.of_unknown[std::size_t(i)]) += fine(i);
  }

  static void add_prolongation(const Aggregates& aggregates, const Vector& coarse, Vector& fine) {
    for (Eigen::Index i = 0; i < fine.size(); ++i)
      fine(i) += coarse(aggregates.of_unknown[std::size_t(i)]);
  }

  Incomplete_factorization<1> m_of_near_part;
  Aggregates m_aggregates; // of the finest level
  Vector m_coarse_in, m_coarse_out;
  Levels m_levels; // without the finest and the coarsest level
  Eigen::SimplicialLDLT<Matrix> m_of_coarsest;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_MULTILEVEL_PRECONDITIONER_H
