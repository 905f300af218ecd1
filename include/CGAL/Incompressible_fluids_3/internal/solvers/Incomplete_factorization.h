// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Incompressible_fluids_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_INCOMPLETE_FACTORIZATION_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_INCOMPLETE_FACTORIZATION_H

#include <CGAL/Incompressible_fluids_3/internal/solvers/unit_of.h>

#include <Eigen/Core>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// An approximation of the inverse of a symmetric positive definite matrix, by incomplete Cholesky
// factorization. It is a preconditioner, for one or several right sides at once. It uses single
// precision, which is faster. A preconditioner must be symmetric, but it need not be exact.
template <int columns> class Incomplete_factorization
{
public:
  using Matrix = Eigen::SparseMatrix<double>; // its lower triangle
  using Vector = Eigen::VectorXd;

  // Computes the factorization. Returns whether it exists.
  bool compute(const Matrix& lower) {
    m_unit = unit_of(lower.diagonal().size() > 0 ? lower.diagonal().maxCoeff() : 0);
    m_scale = (lower.diagonal() / m_unit).cwiseSqrt().cwiseInverse();
    if (!m_scale.allFinite())
      return false;
    const Eigen::SparseMatrix<float> scaled =
        (m_scale.asDiagonal() * (lower / m_unit) * m_scale.asDiagonal()).cast<float>();
    m_factorization.compute(scaled);
    if (m_factorization.info() != Eigen::Success)
      return false;
    m_scale.array() *= m_factorization.scalingS().cast<double>().array();
    m_values.resize(columns, m_scale.size());
    return true;
  }

  // Applies the approximate inverse to `columns` numbers for each row. Only one thread at a time
  // can call it.
  template <class In, class Out> void solve(const In& in, Out&& out) {
    // The scale brings the vector into the range of floats.
    const double size = in.template lpNorm<Eigen::Infinity>();
    const auto& l = m_factorization.matrixL();
    const Eigen::Index n = m_scale.size();
    const auto* begin = l.outerIndexPtr();
    const auto* row = l.innerIndexPtr();
    const float* value = l.valuePtr();
    for (Eigen::Index i = 0; i < n; ++i)
      m_values.col(i) =
          (m_scale(i) / (size > 0 ? size : 1) * in.template segment<columns>(columns * i))
              .template cast<float>();
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
      out.template segment<columns>(columns * i) =
          size / m_unit * m_scale(i) * m_values.col(i).template cast<double>();
  }

private:
  using Column = Eigen::Matrix<float, columns, 1>;

  double m_unit; // of the entries of the matrix, so that scaled entries are near 1
  Vector m_scale;
  Eigen::IncompleteCholesky<float, Eigen::Lower, Eigen::NaturalOrdering<int>> m_factorization;
  Eigen::Matrix<float, columns, Eigen::Dynamic> m_values;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_INCOMPLETE_FACTORIZATION_H
