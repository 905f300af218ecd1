// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Incompressible_fluids_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_PRESSURE_MATRIX_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_PRESSURE_MATRIX_H

#include <CGAL/Deformable_simplicial_complexes/For_each_index.h>
#include <CGAL/Incompressible_fluids_3/Saddle_point_system.h>
#include <CGAL/Incompressible_fluids_3/internal/solvers/Saddle_point_operator.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Returns the lower triangle of b P D^-1 P b^T + c, an approximation of the Schur complement of
// pressures, multiplied by `factor`. D is the inertia of velocities. The velocities of bodies are
// omitted: each one would add a dense block of rank 1. A general product of sparse matrices would
// not use that the result is symmetric.
inline Eigen::SparseMatrix<double> pressure_matrix(const For_each_index& for_each,
                                                   const Saddle_point_system& system,
                                                   const Saddle_point_operator<double>& matrix,
                                                   double factor) {
  // Without a free surface, a constant pressure has no effect, and the matrix is singular. The
  // factor is above the rounding of single precision, which is used for the factorization.
  static constexpr double above_zero = 1 + 1e-6;
  static constexpr std::size_t parts = 16; // each part has a vector of the size of all pressures
  using Index = Eigen::SparseMatrix<double>::StorageIndex;
  const Eigen::Index n = matrix.nodal().rows(), m = matrix.c().rows(),
                     vertices = n - system.velocities_of_bodies;
  std::vector<const Eigen::Matrix3d*> projections(std::size_t(n), nullptr);
  for (const auto& h : system.constrained)
    projections[std::size_t(h.vertex)] = &h.projection;

  Eigen::SparseMatrix<double> result(m, m);
  Index* const ends = result.outerIndexPtr() + 1;
  std::array<std::vector<Index>, parts> rows;
  std::array<std::vector<double>, parts> values;
  for_each(
      parts,
      [&](std::size_t part) {
        std::vector<double> sums(std::size_t(m), 0);
        std::vector<char> is_met(std::size_t(m), false);
        std::vector<Index> met;
        const auto add = [&](Eigen::Index q, double value) {
          if (!is_met[std::size_t(q)]) {
            is_met[std::size_t(q)] = true;
            met.push_back(Index(q));
          }
          sums[std::size_t(q)] += value;
        };
        const Eigen::Index end = m * Eigen::Index(part + 1) / Eigen::Index(parts);
        for (Eigen::Index p = m * Eigen::Index(part) / Eigen::Index(parts); p < end; ++p) {
          matrix.b().for_each_in_row(p, [&](Eigen::Index v, const auto& of_volume) {
            if (v >= vertices)
              return;
            Eigen::Vector3d gradient = of_volume;
            if (projections[std::size_t(v)])
              gradient = (*projections[std::size_t(v)] * gradient).eval();
            gradient *= factor / system.inertia(v);
            matrix.bt().for_each_in_row(v, [&](Eigen::Index q, const auto& other) {
              if (q >= p)
                add(q, gradient.dot(other));
            });
          });
          matrix.c().for_each_in_row(p, [&](Eigen::Index q, const auto& value) {
            if (q >= p)
              add(q, factor * value(0));
          });
          sums[std::size_t(p)] *= above_zero;
          std::sort(met.begin(), met.end());
          for (Index q : met) {
            rows[part].push_back(q);
            values[part].push_back(std::exchange(sums[std::size_t(q)], 0.));
            is_met[std::size_t(q)] = false;
          }
          ends[p] = Index(met.size());
          met.clear();
        }
      },
      2);
  for (Eigen::Index p = 1; p < m; ++p)
    ends[p] += ends[p - 1];
  result.resizeNonZeros(m > 0 ? ends[m - 1] : 0);
  Eigen::Index begin = 0;
  for (std::size_t part = 0; part < parts; ++part) {
    std::copy(rows[part].begin(), rows[part].end(), result.innerIndexPtr() + begin);
    std::copy(values[part].begin(), values[part].end(), result.valuePtr() + begin);
    begin += Eigen::Index(rows[part].size());
  }
  return result;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_PRESSURE_MATRIX_H
