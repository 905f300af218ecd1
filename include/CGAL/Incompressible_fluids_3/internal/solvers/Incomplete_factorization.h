// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Incompressible_fluids_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_INCOMPLETE_FACTORIZATION_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_INCOMPLETE_FACTORIZATION_H

#include <Eigen/Core>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

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

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_INCOMPLETE_FACTORIZATION_H
