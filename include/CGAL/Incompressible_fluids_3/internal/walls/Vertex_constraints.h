// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_WALLS_VERTEX_CONSTRAINTS_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_WALLS_VERTEX_CONSTRAINTS_H

#include <CGAL/Incompressible_fluids_3/Saddle_point_system.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/fluid_vectors.h>
#include <CGAL/Incompressible_fluids_3/internal/walls/Body_motion.h>

#include <optional>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The constraints on the velocities of vertices. A velocity is the sum of a prescribed vector, of
// vectors that are linear in the unknown velocities of rigid bodies, and of a vector v with P v =
// v, where P is the orthogonal projection onto the free directions. Several constraints of a vertex
// hold together. If they contradict each other, the squares of their violations have the least sum.
class Vertex_constraints
{
public:
  // The body to whose motion a constraint is attached.
  struct Attached_body
  {
    std::size_t body;    // its number
    Eigen::Vector3d arm; // the vector from its center to the vertex
  };

  // A prescribed velocity along a direction of unit length. If a body is given, it is prescribed
  // relative to the body.
  struct Known
  {
    Eigen::Vector3d direction;
    double velocity;
    std::optional<Attached_body> body = {};
  };

  // A part of the velocity of a vertex: a matrix times the velocity of a body at the vertex.
  struct Attachment
  {
    std::size_t vertex;
    Attached_body body;
    Eigen::Matrix3d matrix;
  };

  explicit Vertex_constraints(std::size_t number_of_vertices) : m_known(number_of_vertices) {}

  void add(std::size_t v, const Known& known) { m_known[v].push_back(known); }

  // Computes the prescribed velocities, the projections and the attachments. Call it after the last
  // `add()`.
  void close() {
    // Two directions can be the same, for example where two walls touch.
    static constexpr double parallel = 1e-6;
    m_prescribed = Eigen::VectorXd::Zero(3 * Eigen::Index(m_known.size()));
    m_constrained.clear();
    m_attachments.clear();
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
      // The velocity with given components along the directions, by components.
      const Eigen::MatrixXd of_components =
          known *
          (directions.transpose() * known).completeOrthogonalDecomposition().pseudoInverse();
      m_prescribed.segment<3>(3 * Eigen::Index(v)) = of_components * velocities;
      m_constrained.push_back({Eigen::Index(v), free * free.transpose()});
      for (std::size_t i = 0; i < m_known[v].size(); ++i)
        if (const auto& body = m_known[v][i].body)
          m_attachments.push_back(
              {v, *body, of_components.col(Eigen::Index(i)) * m_known[v][i].direction.transpose()});
    }
  }

  // Replaces velocities of constrained vertices by the nearest ones that meet the constraints.
  // `of_bodies` are the velocities of bodies, by number.
  void apply(const std::vector<Body_velocity>& of_bodies, Vectors_3& velocities) const {
    for (const auto& c : m_constrained) {
      Eigen::Vector3d& v = velocities[std::size_t(c.vertex)];
      v = (c.projection * v + m_prescribed.segment<3>(3 * c.vertex)).eval();
    }
    for (const Attachment& a : m_attachments)
      velocities[a.vertex] += a.matrix * of_bodies[a.body.body].at(a.body.arm);
  }

  const Eigen::VectorXd& prescribed() const { return m_prescribed; }
  const std::vector<Saddle_point_system::Constrained_velocity>& constrained() const {
    return m_constrained;
  }
  const std::vector<Attachment>& attachments() const { return m_attachments; }

private:
  std::vector<std::vector<Known>> m_known;
  Eigen::VectorXd m_prescribed;
  std::vector<Saddle_point_system::Constrained_velocity> m_constrained;
  std::vector<Attachment> m_attachments;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_WALLS_VERTEX_CONSTRAINTS_H
