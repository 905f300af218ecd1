// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Incompressible_fluids_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_AGGREGATES_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_AGGREGATES_H

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

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

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_AGGREGATES_H
