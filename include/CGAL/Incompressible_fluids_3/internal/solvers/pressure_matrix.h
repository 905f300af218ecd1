// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_PRESSURE_MATRIX_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_PRESSURE_MATRIX_H

#include <CGAL/Incompressible_fluids_3/Saddle_point_system.h>
#include <CGAL/Incompressible_fluids_3/internal/solvers/Saddle_point_operator.h>
#include <CGAL/Mesh_support/For_each_index.h>
#include <CGAL/Mesh_support/internal/sets/Disjoint_sets.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the closed sets of a system whose other members are complete. The weight of a closed set
// is the mean diagonal entry of c for its pressures. Takes almost linear time.
inline std::vector<Saddle_point_system::Closed_set> closed_sets(const Saddle_point_system& system) {
  static constexpr double rounding = 1e-4; // of the force of a constant pressure
  // The greatest force of a constant pressure on a liquid without any boundary, which fills a
  // torus, relative to the forces of the pressures of single vertices.
  static constexpr double rounding_of_sums = 1e-12;
  using Vector = Saddle_point_system::Vector;
  using Closed_set = Saddle_point_system::Closed_set;
  const Eigen::Index n = system.nodal.rows(), m = system.c.rows();
  // The forces of a constant pressure 1 on vertices, before and after the projection.
  const Vector pushes = system.b.transpose() * Vector::Ones(m);
  Vector free_pushes = pushes;
  system.project(free_pushes);
  // Pressures that act on a common vertex belong to the same set.
  const auto group_of_vertex = [m](Eigen::Index v) { return std::size_t(m + v); };
  Disjoint_sets groups(std::size_t(m + n));
  for (Eigen::Index p = 0; p < m; ++p)
    for (Saddle_point_system::Matrix::InnerIterator i(system.b, p); i; ++i)
      groups.join(std::size_t(p), group_of_vertex(i.col() / 3));
  struct Sums
  {
    double area = 0, free_area = 0, all = 0; // sums of squares of forces
    Closed_set set;
  };
  std::vector<Sums> sums(groups.size());
  for (Eigen::Index v = 0; v < n; ++v) {
    Sums& s = sums[groups.find(group_of_vertex(v))];
    s.area += pushes.segment<3>(3 * v).squaredNorm();
    s.free_area += free_pushes.segment<3>(3 * v).squaredNorm();
  }
  for (Eigen::Index p = 0; p < m; ++p) {
    Sums& s = sums[groups.find(std::size_t(p))];
    for (Saddle_point_system::Matrix::InnerIterator i(system.b, p); i; ++i)
      s.all += i.value() * i.value();
    s.set.pressures.push_back(p);
    s.set.weight += system.c.coeff(p, p);
  }
  std::vector<Closed_set> result;
  for (Sums& s : sums)
    if (!s.set.pressures.empty() && (s.free_area <= rounding * rounding * s.area ||
                                     s.free_area <= rounding_of_sums * rounding_of_sums * s.all)) {
      s.set.weight /= double(s.set.pressures.size());
      result.push_back(std::move(s.set));
    }
  return result;
}

// The matrix b P D^-1 P b^T + c, an approximation of the Schur complement of pressures, multiplied
// by a factor. D is the inertia of velocities. The velocities of bodies are omitted: each one would
// add a dense block of rank 1.
class Pressure_rows
{
public:
  // The system and its operator must outlive the object. Only constraints, inertia and bodies of
  // the system are used.
  Pressure_rows(const Saddle_point_system& system, const Saddle_point_operator<double>& matrix,
                double factor = 1)
      : m_system(system), m_matrix(matrix), m_factor(factor),
        m_vertices(matrix.nodal().rows() - system.velocities_of_bodies),
        m_projections(std::size_t(matrix.nodal().rows()), nullptr) {
    for (const auto& h : system.constrained)
      m_projections[std::size_t(h.vertex)] = &h.projection;
  }

  // Calls `add(column, value)` for the terms of the entries of a row, from the column `first` on.
  template <class Add> void add_row(Eigen::Index row, Eigen::Index first, const Add& add) const {
    m_matrix.b().for_each_in_row(row, [&](Eigen::Index v, const auto& of_volume) {
      if (v >= m_vertices)
        return;
      Eigen::Vector3d gradient = of_volume;
      if (m_projections[std::size_t(v)])
        gradient = (*m_projections[std::size_t(v)] * gradient).eval();
      gradient *= m_factor / m_system.inertia(v);
      m_matrix.bt().for_each_in_row(v, [&](Eigen::Index column, const auto& other) {
        if (column >= first)
          add(column, gradient.dot(other));
      });
    });
    m_matrix.c().for_each_in_row(row, [&](Eigen::Index column, const auto& value) {
      if (column >= first)
        add(column, m_factor * value(0));
    });
  }

private:
  const Saddle_point_system& m_system;
  const Saddle_point_operator<double>& m_matrix;
  double m_factor;
  Eigen::Index m_vertices; // without bodies
  std::vector<const Eigen::Matrix3d*> m_projections;
};

// A sparse row that is the sum of terms.
class Sum_of_row
{
public:
  explicit Sum_of_row(Eigen::Index columns)
      : m_sums(std::size_t(columns), 0), m_is_met(std::size_t(columns), false) {}

  void add(Eigen::Index column, double value) {
    if (!m_is_met[std::size_t(column)]) {
      m_is_met[std::size_t(column)] = true;
      m_met.push_back(column);
    }
    m_sums[std::size_t(column)] += value;
  }

  // Multiplies an entry by a factor.
  void scale(Eigen::Index column, double factor) { m_sums[std::size_t(column)] *= factor; }

  // Calls `take(column, value)` for each entry by increasing column, and clears the row. Returns
  // the number of entries.
  template <class Take> std::size_t take(const Take& take) {
    std::sort(m_met.begin(), m_met.end());
    for (Eigen::Index column : m_met) {
      take(column, std::exchange(m_sums[std::size_t(column)], 0.));
      m_is_met[std::size_t(column)] = false;
    }
    const std::size_t result = m_met.size();
    m_met.clear();
    return result;
  }

private:
  std::vector<double> m_sums;
  std::vector<char> m_is_met;
  std::vector<Eigen::Index> m_met;
};

// The factor of diagonal entries. Without a free surface, a constant pressure has no effect, and
// the matrix is singular. The factor is above the rounding of single precision, which
// factorizations use.
constexpr double above_singular = 1 + 1e-6;

// Returns the lower triangle of the matrix of `Pressure_rows`, with diagonal entries multiplied by
// `above_singular`.
inline Eigen::SparseMatrix<double> pressure_matrix(const For_each_index& for_each,
                                                   const Saddle_point_system& system,
                                                   const Saddle_point_operator<double>& matrix,
                                                   double factor) {
  static constexpr std::size_t parts = 16; // each part has a vector of the size of all pressures
  using Index = Eigen::SparseMatrix<double>::StorageIndex;
  const Eigen::Index m = matrix.c().rows();
  const Pressure_rows of_pressures(system, matrix, factor);
  Eigen::SparseMatrix<double> result(m, m);
  Index* const ends = result.outerIndexPtr() + 1;
  std::array<std::vector<Index>, parts> rows;
  std::array<std::vector<double>, parts> values;
  for_each(
      parts,
      [&](std::size_t part) {
        Sum_of_row sum(m);
        const Eigen::Index end = m * Eigen::Index(part + 1) / Eigen::Index(parts);
        for (Eigen::Index p = m * Eigen::Index(part) / Eigen::Index(parts); p < end; ++p) {
          // The matrix is symmetric, so a column of the lower triangle is a part of a row.
          of_pressures.add_row(p, p, [&sum](Eigen::Index q, double value) { sum.add(q, value); });
          sum.scale(p, above_singular);
          ends[p] = Index(sum.take([&](Eigen::Index q, double value) {
            rows[part].push_back(Index(q));
            values[part].push_back(value);
          }));
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

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_PRESSURE_MATRIX_H
