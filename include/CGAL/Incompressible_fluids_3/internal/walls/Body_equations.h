// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Incompressible_fluids_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_WALLS_BODY_EQUATIONS_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_WALLS_BODY_EQUATIONS_H

#include <CGAL/Incompressible_fluids_3/Saddle_point_system.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/fluid_vectors.h>
#include <CGAL/Incompressible_fluids_3/internal/walls/Body_motion.h>
#include <CGAL/Incompressible_fluids_3/internal/walls/Vertex_constraints.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

/*
The equations of motion of rigid bodies. They are solved together with the equations of the liquids.
Each body adds two unknowns to a system: the velocity of its center, and its angular velocity times
a length. A vertex that a body constrains has the velocity

   prescribed + sum of (matrix of the attachment) (velocity of the body at the vertex) + P u,

see `Vertex_constraints`. With this substitution, the forces that the body exerts on its vertices
cancel in the equations. The system remains symmetric, and `a` positive definite, for bodies of any
mass: the liquid that moves with a body adds its own inertia.
*/
class Body_equations
{
public:
  using System = Saddle_point_system;
  using Vector = System::Vector;
  using Matrix = System::Matrix;

  // A body in a step.
  struct Body
  {
    Body_inertia inertia;
    Body_velocity velocity; // at the beginning
    Body_place begin, middle;
  };

  Body_equations() = default;

  // Prepares the equations of a step. Forces act at the time `time`, which is theta dt.
  // `constraints` are the constraints on `number_of_velocities` velocities, after `close()`.
  Body_equations(std::vector<Body> bodies, double time, const Eigen::Vector3d& gravity,
                 std::size_t number_of_velocities, const Vertex_constraints& constraints)
      : m_bodies(std::move(bodies)), m_time(time), m_gravity(gravity),
        m_first(3 * Eigen::Index(number_of_velocities)), m_lengths(m_bodies.size(), 0) {
    for (const auto& a : constraints.attachments())
      m_lengths[a.body.body] = (std::max)(m_lengths[a.body.body], a.body.arm.norm());
    for (double& length : m_lengths)
      length = length > 0 ? length : 1; // has no effect, because no vertex is attached
    m_columns.assign(6 * m_bodies.size(), Vector::Zero(m_first));
    for (const auto& a : constraints.attachments()) {
      const Eigen::Matrix3d turn = a.matrix * cross_matrix(a.body.arm) / m_lengths[a.body.body];
      for (int axis = 0; axis < 3; ++axis) {
        column(a.body.body, axis).segment<3>(3 * Eigen::Index(a.vertex)) += a.matrix.col(axis);
        column(a.body.body, 3 + axis).segment<3>(3 * Eigen::Index(a.vertex)) += turn.col(axis);
      }
    }
  }

  // A volume that a pressure gains by the velocity of a body at a point, times a vector.
  struct Flux
  {
    Eigen::Index pressure;
    Vertex_constraints::Attached_body body;
    Eigen::Vector3d vector;
  };

  // Adds the bodies to a system whose other members are complete, with fluxes of its matrix b.
  void extend(System& system, const std::vector<Flux>& fluxes) const;

  // Returns the right side f of an extended system. The argument is f of the system.
  Vector forces(const Vector& f) const {
    Vector result(m_first + Eigen::Index(m_columns.size()));
    result.head(m_first) = f;
    for (std::size_t k = 0; k < m_columns.size(); ++k)
      result(m_first + Eigen::Index(k)) = m_columns[k].dot(f);
    for (std::size_t k = 0; k < m_bodies.size(); ++k) {
      const Body& body = m_bodies[k];
      auto own = result.segment<6>(m_first + 6 * Eigen::Index(k));
      own.head<3>() += body.inertia.mass() * (body.velocity.linear / m_time + m_gravity);
      own.tail<3>() += angular_momentum(k) / (m_time * m_lengths[k]);
    }
    return result;
  }

  // Returns the unknowns of an extended system for given velocities of vertices and of bodies.
  Vector unknowns(const Vector& velocities, const std::vector<Body_velocity>& of_bodies) const {
    Vector result(m_first + Eigen::Index(m_columns.size()));
    for (std::size_t k = 0; k < m_bodies.size(); ++k)
      result.segment<6>(m_first + 6 * Eigen::Index(k)) << of_bodies[k].linear,
          m_lengths[k] * of_bodies[k].angular;
    result.head(m_first) = velocities - attached(result);
    return result;
  }

  // Returns the unknowns of the system that unknowns of the extended system determine, less the
  // prescribed velocities.
  Vector velocities(const Vector& unknowns) const {
    return unknowns.head(m_first) + attached(unknowns);
  }

  // Returns the velocities of bodies.
  std::vector<Body_velocity> velocities_of_bodies(const Vector& unknowns) const {
    std::vector<Body_velocity> result;
    for (std::size_t k = 0; k < m_bodies.size(); ++k) {
      const auto own = unknowns.segment<6>(m_first + 6 * Eigen::Index(k));
      result.push_back({own.head<3>(), own.tail<3>() / m_lengths[k]});
    }
    return result;
  }

  // Returns the velocities of bodies at the end of a step of length dt, given their velocities in
  // the step. The angular momentum about free axes changes by the torques alone.
  std::vector<Body_velocity> final_velocities(const std::vector<Body_velocity>& in_step,
                                              double dt) const {
    std::vector<Body_velocity> result;
    for (std::size_t k = 0; k < m_bodies.size(); ++k) {
      const Body& body = m_bodies[k];
      const Eigen::Vector3d momentum = angular_momentum(k),
                            in_middle = inertia_in_middle(k) * in_step[k].angular;
      const Eigen::Quaterniond rotation = body.begin.moved(in_step[k], dt).rotation;
      result.push_back(
          {body.velocity.linear + dt / m_time * (in_step[k].linear - body.velocity.linear),
           body.inertia.angular_velocity(rotation,
                                         momentum + dt / m_time * (in_middle - momentum))});
    }
    return result;
  }

  // A contact of a vertex at the end of a step: the component of its velocity that the body
  // determines, and the vector from the center of the body.
  struct Stop
  {
    std::size_t body, vertex;
    Eigen::Matrix3d projection;
    Eigen::Vector3d arm;
  };

  // Returns velocities of bodies after an inelastic impact: then the vertices in contact move with
  // them, and the momenta of each body and its vertices together are preserved.
  std::vector<Body_velocity> after_impact(const std::vector<Body_velocity>& before,
                                          const Vectors_3& of_vertices,
                                          const std::vector<double>& masses,
                                          const std::vector<Stop>& stops) const {
    using Matrix_6 = Eigen::Matrix<double, 6, 6>;
    using Vector_6 = Eigen::Matrix<double, 6, 1>;
    std::vector<Matrix_6> mass(before.size(), Matrix_6::Zero());
    std::vector<Vector_6> impulse(before.size(), Vector_6::Zero());
    for (const Stop& stop : stops) {
      const double length = m_lengths[stop.body];
      Eigen::Matrix<double, 3, 6> velocity; // of the contact, by the motion of the body
      velocity << stop.projection, stop.projection * cross_matrix(stop.arm) / length;
      mass[stop.body] += masses[stop.vertex] * velocity.transpose() * velocity;
      impulse[stop.body] += masses[stop.vertex] * velocity.transpose() *
                            (of_vertices[stop.vertex] - before[stop.body].at(stop.arm));
    }
    std::vector<Body_velocity> result = before;
    for (std::size_t k = 0; k < before.size(); ++k) {
      const Body_inertia& inertia = m_bodies[k].inertia;
      Matrix_6 is_free = Matrix_6::Zero();
      is_free.topLeftCorner<3, 3>() = inertia.translations();
      is_free.bottomRightCorner<3, 3>() = inertia.rotations();
      mass[k].topLeftCorner<3, 3>().diagonal().array() += inertia.mass();
      mass[k].bottomRightCorner<3, 3>() += inertia_in_middle(k) / (m_lengths[k] * m_lengths[k]);
      const Matrix_6 restricted =
          is_free * mass[k] * is_free + inertia.mass() * (Matrix_6::Identity() - is_free);
      const Vector_6 change = restricted.ldlt().solve(is_free * impulse[k]);
      result[k].linear += change.head<3>();
      result[k].angular += change.tail<3>() / m_lengths[k];
    }
    return result;
  }

private:
  // Returns the matrix that maps w to the cross product of w and r.
  static Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& r) {
    Eigen::Matrix3d result;
    result << 0, r.z(), -r.y(), -r.z(), 0, r.x(), r.y(), -r.x(), 0;
    return result;
  }

  Vector& column(std::size_t body, int k) { return m_columns[6 * body + std::size_t(k)]; }

  Eigen::Matrix3d inertia_in_middle(std::size_t k) const {
    return m_bodies[k].inertia.inertia(m_bodies[k].middle.rotation);
  }
  // Returns the angular momentum at the beginning.
  Eigen::Vector3d angular_momentum(std::size_t k) const {
    const Body& body = m_bodies[k];
    return body.inertia.inertia(body.begin.rotation) * body.velocity.angular;
  }

  // Returns the velocities of vertices by the motion of bodies.
  Vector attached(const Vector& unknowns) const {
    Vector result = Vector::Zero(m_first);
    for (std::size_t k = 0; k < m_columns.size(); ++k)
      result += unknowns(m_first + Eigen::Index(k)) * m_columns[k];
    return result;
  }

  std::vector<Body> m_bodies;
  double m_time = 1;
  Eigen::Vector3d m_gravity = Eigen::Vector3d::Zero();
  Eigen::Index m_first = 0;      // the first number of bodies in a vector of velocities
  std::vector<double> m_lengths; // by body: the unit of length of its rotation
  std::vector<Vector> m_columns; // six for each body: velocities of vertices by unknown
};

inline void Body_equations::extend(System& system, const std::vector<Flux>& fluxes) const {
  if (m_bodies.empty())
    return;
  using Entries = std::vector<Eigen::Triplet<double>>;
  const Eigen::Index n = m_first / 3, all = n + 2 * Eigen::Index(m_bodies.size()),
                     pressures = system.b.rows();
  const int first = int(m_first);
  Entries of_nodal, of_coupling, of_b;
  system.inertia.conservativeResize(all);
  std::vector<Vector> products; // a times each column
  for (const Vector& column : m_columns)
    products.push_back(system.multiply_a(column));
  // The entries of bodies.
  for (std::size_t k = 0; k < m_bodies.size(); ++k) {
    const int row = first + 6 * int(k);
    Eigen::Matrix<double, 6, 6> block = Eigen::Matrix<double, 6, 6>::Zero();
    block.topLeftCorner<3, 3>().diagonal().setConstant(m_bodies[k].inertia.mass() / m_time);
    block.bottomRightCorner<3, 3>() = inertia_in_middle(k) / (m_time * m_lengths[k] * m_lengths[k]);
    for (int part : {0, 1}) {
      const Eigen::Matrix3d projection =
          part == 0 ? m_bodies[k].inertia.translations() : m_bodies[k].inertia.rotations();
      // The mean inertia of the three directions, including the inertia of the attached vertices.
      double mean = block.block<3, 3>(3 * part, 3 * part).trace() / 3;
      for (int axis = 0; axis < 3; ++axis) {
        const std::size_t c = 6 * k + std::size_t(3 * part + axis);
        mean += m_columns[c].dot(products[c]) / 3;
      }
      const int v = int(n) + 2 * int(k) + part;
      system.inertia(v) = mean;
      of_nodal.emplace_back(v, v, mean);
      block.block<3, 3>(3 * part, 3 * part).diagonal().array() -= mean;
      if (!projection.isIdentity(0))
        system.constrained.push_back({v, projection});
    }
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j)
        of_coupling.emplace_back(row + i, row + j, block(i, j));
  }
  // The entries of bodies and vertices, and of two bodies at common vertices.
  for (std::size_t k = 0; k < m_columns.size(); ++k) {
    const int row = first + int(k);
    for (Eigen::Index i = 0; i < m_first; ++i)
      if (const double value = products[k](i); value != 0) {
        of_coupling.emplace_back(row, int(i), value);
        of_coupling.emplace_back(int(i), row, value);
      }
    for (std::size_t j = 0; j < m_columns.size(); ++j)
      of_coupling.emplace_back(row, first + int(j), m_columns[j].dot(products[k]));
  }
  // The gradients of volumes.
  for (std::size_t k = 0; k < m_columns.size(); k += 3) {
    Eigen::Matrix<double, Eigen::Dynamic, 3> gradients(pressures, 3);
    for (int axis = 0; axis < 3; ++axis)
      gradients.col(axis) = system.b * m_columns[k + std::size_t(axis)];
    for (Eigen::Index p = 0; p < pressures; ++p)
      for (int axis = 0; axis < 3 && !gradients.row(p).isZero(0); ++axis)
        of_b.emplace_back(int(p), first + int(k) + axis, gradients(p, axis));
  }
  for (const Flux& flux : fluxes) {
    const Eigen::Vector3d turn =
        cross_matrix(flux.body.arm).transpose() * flux.vector / m_lengths[flux.body.body];
    for (int axis = 0; axis < 3; ++axis) {
      const int column = first + 6 * int(flux.body.body) + axis;
      of_b.emplace_back(int(flux.pressure), column, flux.vector(axis));
      of_b.emplace_back(int(flux.pressure), column + 3, turn(axis));
    }
  }
  const auto add = [](Matrix& matrix, Eigen::Index rows, Eigen::Index columns,
                      const Entries& entries) {
    Matrix more(rows, columns);
    more.setFromTriplets(entries.begin(), entries.end());
    matrix.conservativeResize(rows, columns);
    matrix = Matrix(matrix + more);
  };
  add(system.nodal, all, all, of_nodal);
  add(system.coupling, 3 * all, 3 * all, of_coupling);
  add(system.b, pressures, 3 * all, of_b);
  system.velocities_of_bodies = all - n;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_WALLS_BODY_EQUATIONS_H
