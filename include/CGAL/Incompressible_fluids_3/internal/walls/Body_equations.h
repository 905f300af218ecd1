// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_WALLS_BODY_EQUATIONS_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_WALLS_BODY_EQUATIONS_H

#include <CGAL/Incompressible_fluids_3/Saddle_point_system.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/fluid_vectors.h>
#include <CGAL/Incompressible_fluids_3/internal/solvers/relative_residual.h>
#include <CGAL/Incompressible_fluids_3/internal/walls/Body_motion.h>
#include <CGAL/Incompressible_fluids_3/internal/walls/Vertex_constraints.h>

#include <Eigen/SparseCholesky>

namespace CGAL::Deformable_simplicial_complexes::internal {

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
    m_columns = motions_of_vertices(constraints);
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
    Vector result(m_first + m_columns.cols());
    result << f, m_columns.transpose() * f;
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
    Vector result(m_first + m_columns.cols());
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

  // Returns velocities of bodies after an inelastic impact: then the constrained vertices move with
  // the bodies. The sum of the momenta of the bodies and their vertices is preserved, except for
  // the impulses of walls that no body moves. `constraints` are those at the end of the step, after
  // `close()`.
  std::vector<Body_velocity> after_impact(const std::vector<Body_velocity>& before,
                                          const Vectors_3& of_vertices,
                                          const std::vector<double>& masses,
                                          const Vertex_constraints& constraints) const {
    const auto all = Eigen::Index(6 * m_bodies.size());
    const Columns motions = motions_of_vertices(constraints);
    Vector velocities(all), is_free(all), mass(m_first);
    Entries own, fixed;
    for (std::size_t k = 0; k < m_bodies.size(); ++k) {
      const auto first = 6 * Eigen::Index(k);
      const Body_inertia& inertia = m_bodies[k].inertia;
      velocities.segment<6>(first) << before[k].linear, m_lengths[k] * before[k].angular;
      is_free.segment<6>(first) << inertia.translations().diagonal(),
          inertia.rotations().diagonal();
      add_block(first, first, inertia_of_unknowns(k), own);
    }
    for (Eigen::Index i = 0; i < all; ++i)
      fixed.emplace_back(int(i), int(i), 1 - is_free(i));
    for (std::size_t v = 0; v < masses.size(); ++v)
      mass.segment<3>(3 * Eigen::Index(v)).setConstant(masses[v]);
    Vector missing = -constraints.prescribed() - motions * velocities;
    for (const auto& c : constraints.constrained()) {
      const Eigen::Vector3d& v = of_vertices[std::size_t(c.vertex)];
      missing.segment<3>(3 * c.vertex) += v - c.projection * v;
    }
    const Columns weighted = mass.asDiagonal() * motions;
    Columns inertia = motions.transpose() * weighted;
    inertia += matrix_of(own, all, all);
    inertia = is_free.asDiagonal() * inertia;
    inertia = inertia * is_free.asDiagonal();
    inertia += matrix_of(fixed, all, all);
    const Eigen::SimplicialLDLT<Columns> factorization(inertia);
    if (factorization.info() != Eigen::Success)
      throw_singular_equations();
    const Vector impulse = is_free.cwiseProduct(weighted.transpose() * missing),
                 change = factorization.solve(impulse);
    std::vector<Body_velocity> result = before;
    for (std::size_t k = 0; k < before.size(); ++k) {
      result[k].linear += change.segment<3>(6 * Eigen::Index(k));
      result[k].angular += change.segment<3>(6 * Eigen::Index(k) + 3) / m_lengths[k];
    }
    return result;
  }

private:
  using Columns = Eigen::SparseMatrix<double>;
  using Entries = std::vector<Eigen::Triplet<double>>;
  using Matrix_6 = Eigen::Matrix<double, 6, 6>;

  // Returns the matrix that maps w to the cross product of w and r.
  static Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& r) {
    Eigen::Matrix3d result;
    result << 0, r.z(), -r.y(), -r.z(), 0, r.x(), r.y(), -r.x(), 0;
    return result;
  }

  // Appends the entries of a block whose first entry is in the given row and column.
  template <class Block>
  static void add_block(Eigen::Index row, Eigen::Index column, const Block& block,
                        Entries& entries) {
    for (int i = 0; i < Block::RowsAtCompileTime; ++i)
      for (int j = 0; j < Block::ColsAtCompileTime; ++j)
        entries.emplace_back(int(row) + i, int(column) + j, block(i, j));
  }
  static Columns matrix_of(const Entries& entries, Eigen::Index rows, Eigen::Index columns) {
    Columns result(rows, columns);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  // Returns the matrix that maps the unknowns of bodies to velocities of the vertices that they
  // constrain. It has six columns for each body.
  Columns motions_of_vertices(const Vertex_constraints& constraints) const {
    Entries entries;
    for (const auto& a : constraints.attachments()) {
      const auto row = 3 * Eigen::Index(a.vertex), column = 6 * Eigen::Index(a.body.body);
      const Eigen::Matrix3d turn = a.matrix * cross_matrix(a.body.arm) / m_lengths[a.body.body];
      add_block(row, column, a.matrix, entries);
      add_block(row, column + 3, turn, entries);
    }
    return matrix_of(entries, m_first, Eigen::Index(6 * m_bodies.size()));
  }

  // Returns the inertia of a body alone for its six unknowns.
  Matrix_6 inertia_of_unknowns(std::size_t k) const {
    Matrix_6 result = Matrix_6::Zero();
    result.topLeftCorner<3, 3>().diagonal().setConstant(m_bodies[k].inertia.mass());
    result.bottomRightCorner<3, 3>() = inertia_in_middle(k) / (m_lengths[k] * m_lengths[k]);
    return result;
  }
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
    return m_columns * unknowns.tail(m_columns.cols());
  }

  std::vector<Body> m_bodies;
  double m_time = 1;
  Eigen::Vector3d m_gravity = Eigen::Vector3d::Zero();
  Eigen::Index m_first = 0;      // the first number of bodies in a vector of velocities
  std::vector<double> m_lengths; // by body: the unit of length of its rotation
  Columns m_columns;             // see `motions_of_vertices()`
};

inline void Body_equations::extend(System& system, const std::vector<Flux>& fluxes) const {
  if (m_bodies.empty())
    return;
  const Eigen::Index n = m_first / 3, all = n + 2 * Eigen::Index(m_bodies.size()),
                     pressures = system.b.rows();
  Entries of_nodal, of_coupling, of_b, of_a;
  system.inertia.conservativeResize(all);
  for (Eigen::Index v = 0; v < n; ++v)
    for (Matrix::InnerIterator i(system.nodal, v); i; ++i)
      for (int axis = 0; axis < 3; ++axis)
        of_a.emplace_back(3 * int(v) + axis, 3 * int(i.col()) + axis, i.value());
  Matrix a(m_first, m_first);
  a.setFromTriplets(of_a.begin(), of_a.end());
  if (system.coupling.rows() > 0)
    a += system.coupling;
  const Columns products = a * m_columns, own = m_columns.transpose() * products,
                gradients = system.b * m_columns;
  // The entries of bodies.
  for (std::size_t k = 0; k < m_bodies.size(); ++k) {
    const auto first = 6 * Eigen::Index(k);
    Matrix_6 block = inertia_of_unknowns(k) / m_time;
    for (int part : {0, 1}) {
      const Eigen::Matrix3d projection =
          part == 0 ? m_bodies[k].inertia.translations() : m_bodies[k].inertia.rotations();
      // The mean inertia of the three directions, including the inertia of the attached vertices.
      double mean = block.block<3, 3>(3 * part, 3 * part).trace() / 3;
      for (Eigen::Index c = first + 3 * part; c < first + 3 * part + 3; ++c)
        mean += own.coeff(c, c) / 3;
      const int v = int(n) + 2 * int(k) + part;
      system.inertia(v) = mean;
      of_nodal.emplace_back(v, v, mean);
      block.block<3, 3>(3 * part, 3 * part).diagonal().array() -= mean;
      if (!projection.isIdentity(0))
        system.constrained.push_back({v, projection});
    }
    add_block(m_first + first, m_first + first, block, of_coupling);
  }
  // The entries of bodies and vertices, and of two bodies at common vertices.
  for (int k = 0; k < int(m_columns.cols()); ++k) {
    const int row = int(m_first) + k;
    for (Columns::InnerIterator i(products, k); i; ++i) {
      of_coupling.emplace_back(row, int(i.row()), i.value());
      of_coupling.emplace_back(int(i.row()), row, i.value());
    }
    for (Columns::InnerIterator i(own, k); i; ++i)
      of_coupling.emplace_back(row, int(m_first + i.row()), i.value());
  }
  // The gradients of volumes. A row has all three entries of a velocity or none.
  for (int k = 0; k < int(m_columns.cols()); ++k)
    for (Columns::InnerIterator i(gradients, k); i; ++i)
      for (int axis = 0; axis < 3; ++axis)
        of_b.emplace_back(int(i.row()), int(m_first) + k - k % 3 + axis,
                          axis == k % 3 ? i.value() : 0);
  for (const Flux& flux : fluxes) {
    const Eigen::Vector3d turn =
        cross_matrix(flux.body.arm).transpose() * flux.vector / m_lengths[flux.body.body];
    for (int axis = 0; axis < 3; ++axis) {
      const int column = int(m_first) + 6 * int(flux.body.body) + axis;
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

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_WALLS_BODY_EQUATIONS_H
