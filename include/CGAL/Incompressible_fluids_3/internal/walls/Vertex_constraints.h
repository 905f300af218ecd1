// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Incompressible_fluids_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_WALLS_VERTEX_CONSTRAINTS_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_WALLS_VERTEX_CONSTRAINTS_H

#include <CGAL/Incompressible_fluids_3/Saddle_point_system.h>

#include <Eigen/Dense>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// The constraints on the velocities of vertices. A velocity is the sum of a prescribed vector and
// of a vector v with P v = v, where P is the orthogonal projection onto the free directions.
class Vertex_constraints
{
public:
  // A prescribed velocity along a direction of unit length.
  struct Known
  {
    Eigen::Vector3d direction;
    double velocity;
  };

  explicit Vertex_constraints(std::size_t number_of_vertices) : m_known(number_of_vertices) {}

  void add(std::size_t v, const Known& known) { m_known[v].push_back(known); }

  const std::vector<Known>& known(std::size_t v) const { return m_known[v]; }

  // Computes the prescribed velocities and the projections. Call it after the last `add()`.
  void close() {
    // Two directions can be the same, for example where two walls touch.
    static constexpr double parallel = 1e-6;
    m_prescribed = Eigen::VectorXd::Zero(3 * Eigen::Index(m_known.size()));
    m_constrained.clear();
    for (std::size_t v = 0; v < m_known.size(); ++v) {
      if (m_known[v].empty())
        continue;
      Eigen::MatrixXd directions(3, m_known[v].size());
      Eigen::VectorXd velocities(m_known[v].size());
      for (std::size_t i = 0; i < m_known[v].size(); ++i) {
        directions.col(Eigen::Index(i)) = m_known[v][i].direction;
        velocities(Eigen::Index(i)) = m_known[v][i].velocity;
      }
      Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
      qr.setThreshold(parallel);
      qr.compute(directions);
      const Eigen::Matrix3d base = qr.householderQ() * Eigen::Matrix3d::Identity();
      const Eigen::MatrixXd known = base.leftCols(qr.rank()), free = base.rightCols(3 - qr.rank());
      m_prescribed.segment<3>(3 * Eigen::Index(v)) =
          known * (directions.transpose() * known).colPivHouseholderQr().solve(velocities);
      m_constrained.push_back({Eigen::Index(v), free * free.transpose()});
    }
  }

  const Eigen::VectorXd& prescribed() const { return m_prescribed; }
  const std::vector<Saddle_point_system::Constrained_velocity>& constrained() const {
    return m_constrained;
  }

private:
  std::vector<std::vector<Known>> m_known;
  Eigen::VectorXd m_prescribed;
  std::vector<Saddle_point_system::Constrained_velocity> m_constrained;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_WALLS_VERTEX_CONSTRAINTS_H
