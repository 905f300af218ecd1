// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_FLOW_VERTEX_CONSTRAINTS_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_FLOW_VERTEX_CONSTRAINTS_3_H

#include <CGAL/Deformable_simplicial_complex_3/internal/flow/Fluid_mesh_3.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// What is known of the velocities of vertices: v = prescribed + T w, with the columns of T an
// orthonormal base of what is free.
class Vertex_constraints_3
{
public:
  // Along a direction of unit length a velocity is known.
  struct Known
  {
    Eigen::Vector3d direction;
    double velocity;
  };

  explicit Vertex_constraints_3(std::size_t number_of_vertices) : m_known(number_of_vertices) {}

  void add(std::size_t v, const Known& known) { m_known[v].push_back(known); }

  const std::vector<Known>& known(std::size_t v) const { return m_known[v]; }

  // To be called after the last `add()`.
  void close() {
    m_prescribed = Eigen::VectorXd::Zero(3 * Eigen::Index(m_known.size()));
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::Index column = 0;
    for (std::size_t v = 0; v < m_known.size(); ++v) {
      const Eigen::Index row = 3 * Eigen::Index(v);
      Eigen::Matrix3d base = Eigen::Matrix3d::Identity();
      Eigen::Index fixed = 0;
      if (!m_known[v].empty()) {
        // The same direction may be known twice, as where two walls touch.
        static constexpr double parallel = 1e-6;
        Eigen::MatrixXd directions(3, m_known[v].size());
        Eigen::VectorXd velocities(m_known[v].size());
        for (std::size_t i = 0; i < m_known[v].size(); ++i) {
          directions.col(Eigen::Index(i)) = m_known[v][i].direction;
          velocities(Eigen::Index(i)) = m_known[v][i].velocity;
        }
        Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
        qr.setThreshold(parallel);
        qr.compute(directions);
        fixed = qr.rank();
        base = qr.householderQ() * Eigen::Matrix3d::Identity();
        const Eigen::MatrixXd known = base.leftCols(fixed);
        m_prescribed.segment<3>(row) =
            known * (directions.transpose() * known).colPivHouseholderQr().solve(velocities);
      }
      for (Eigen::Index k = fixed; k < 3; ++k, ++column)
        for (Eigen::Index i = 0; i < 3; ++i)
          if (base(i, k) != 0)
            entries.emplace_back(row + i, column, base(i, k));
    }
    m_base = Eigen::SparseMatrix<double>(m_prescribed.size(), column);
    m_base.setFromTriplets(entries.begin(), entries.end());
  }

  const Eigen::VectorXd& prescribed() const { return m_prescribed; }
  const Eigen::SparseMatrix<double>& base() const { return m_base; }

private:
  std::vector<std::vector<Known>> m_known;
  Eigen::VectorXd m_prescribed;
  Eigen::SparseMatrix<double> m_base; // T
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_FLOW_VERTEX_CONSTRAINTS_3_H
