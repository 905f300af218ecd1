// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_STEPS_FLUID_EQUATIONS_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_STEPS_FLUID_EQUATIONS_H

#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Linear_element.h>
#include <CGAL/Incompressible_fluids_3/Fluid_properties.h>
#include <CGAL/Incompressible_fluids_3/Saddle_point_system.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/Fluid_mesh.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/Slip_transform.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/fluid_vectors.h>
#include <CGAL/Incompressible_fluids_3/internal/solvers/Cell_rows.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/For_each_index.h>
#include <CGAL/Mesh_support/internal/numbers/Facet_tension.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

/*
The equations of a time step of length dt of an incompressible flow, by linear finite elements on
tetrahedra, or on triangles in the plane, that move with the flow. The unknowns are the velocities v
at the time theta dt, by which vertices move from x to x + dt v, and the pressures p:

   A v - B^T p = f,   A = M / (theta dt) + K + theta dt L,  f = M (u / (theta dt) + g) - L x + w
   B v + C p   = s + q

M is the mass matrix, see `Fluid_mesh`. K is the viscosity. L x is the gradient of the surface
energy. The vector w contains the forces of gases and of wetted walls. Each row of B is the gradient
of the volume around a vertex, divided by the number of corners of a cell. So B v = 0 preserves this
volume, and B v = q adds the volume of sources.

Without C, these equations permit oscillating pressures that have no effect. The terms C p and s
stabilize them by the residual of the equation of motion (T. J. R. Hughes, L. P. Franca, M.
Balestra, "A new finite element formulation for computational fluid dynamics: V.", 1986). They
cancel if the gradient of p is the density times the difference of gravity and acceleration. The sum
of all rows of C is zero.

Pressures are linear in each cell. With one pressure for each cell, the mesh could perform only
linear motions (locking).

Where two liquids slip along each other, the unknowns are the velocity of the vertex and the
relative velocity of the liquids. The matrices and the forces of cells are transformed to these
unknowns, see `Slip_transform`.
*/
template <class Complex> class Fluid_equations
{
public:
  using Mesh = Fluid_mesh<Complex>;
  using System = Saddle_point_system;
  using Vector = Eigen::VectorXd;
  using Rows = Cell_rows<Mesh::corners>;

  // dt: the length of the time step. theta: 1/2 for the implicit midpoint rule, 1 for the backward
  // Euler method.
  struct Step
  {
    double dt, theta;
  };

  // Prepares the equations for vertices that are at `positions` at the beginning of the step. All
  // loops use `for_each`, which can use several threads.
  Fluid_equations(const For_each_index& for_each, const Mesh& mesh,
                  const Fluid_properties& properties, const Step& step, const Vectors_3& positions)
      : m_for_each(for_each), m_mesh(mesh), m_gravity(properties.gravity().data()), m_step(step),
        m_positions(positions), m_vertices(corners(&Mesh::Cell::vertices)),
        m_pressures(corners(&Mesh::Cell::pressures)),
        m_rows_of_vertices(m_vertices, mesh.vertices.size()),
        m_rows_of_pressures(m_pressures, mesh.vertex_of_pressure.size()),
        m_masses(mesh.vertices.size(), 0), m_slips(mesh) {
    bool is_viscous = false;
    for (const auto& cell : mesh.cells) {
      m_elements.push_back(cell_element<Complex>(mesh.corners_at(cell.vertices, positions)));
      is_viscous = is_viscous || cell.liquid->is_viscous();
      for (auto v : cell.vertices)
        m_masses[v] += cell.liquid->density * m_elements.back().lumped_mass();
    }
    const std::size_t n = m_rows_of_vertices.size(), m = m_rows_of_pressures.size();
    m_of_cells.nodal = m_rows_of_vertices.template zeros<1, 1>(m_vertices, n);
    m_of_cells.b = m_rows_of_pressures.template zeros<1, 3>(m_vertices, n);
    m_system.c = m_rows_of_pressures.template zeros<1, 1>(m_pressures, m);
    if (is_viscous)
      m_of_cells.coupling = m_rows_of_vertices.template zeros<3, 3>(m_vertices, n);
    m_terms.resize(mesh.cells.size());
  }

  // Returns the masses of vertices: equal shares of the masses of the cells around.
  const std::vector<double>& masses() const { return m_masses; }

  // Returns the masses that move with the unknown velocities.
  std::vector<double> masses_of_unknowns() const {
    std::vector<double> result = m_masses;
    for (const auto& slip : m_mesh.slips) {
      result[slip.first] = m_masses[slip.first] + m_masses[slip.second];
      result[slip.second] = slip.share * (1 - slip.share) * result[slip.first];
    }
    return result;
  }

  // The transformation between the velocities of liquids and the unknowns.
  const Slip_transform& slips() const { return m_slips; }

  // Returns the kinetic energy of velocities of liquids.
  double kinetic_energy(const Vectors_3& velocities) const {
    double result = 0;
    for (std::size_t v = 0; v < m_masses.size(); ++v)
      result += (1 - Mesh::part_at_middle) * m_masses[v] / 2 * velocities[v].squaredNorm();
    for (std::size_t k = 0; k < m_mesh.cells.size(); ++k)
      result += Mesh::part_at_middle * Mesh::corners * share_of_mass(k) / 2 *
                m_mesh.middle(k, velocities).squaredNorm();
    return result;
  }

  // Assembles the matrices with the vertices at positions near the midpoint of the step.
  // `tension_of(f)` is the surface tension of facet f, or its energy of wetting per unit of area.
  // `gas_pressures` are the pressures of gases on facets. `velocities` determine viscosities that
  // depend on the shear rate.
  // \throws Error if a viscosity is negative or not finite
  template <class TensionOf>
  void assemble(const Vectors_3& midpoint_positions, const Vectors_3& velocities,
                const TensionOf& tension_of, const std::vector<double>& gas_pressures) {
    m_viscosities.clear(); // by one thread, because functions of users determine them
    for (std::size_t k = 0; k < m_mesh.cells.size(); ++k)
      m_viscosities.push_back(viscosity(k, velocities));
    m_for_each(m_terms.size(), [&](std::size_t k) { m_terms[k] = terms(k, midpoint_positions); });
    using Scalar = Eigen::Matrix<double, 1, 1>;
    m_rows_of_vertices.template sum<1, 1>(
        m_for_each, m_vertices,
        [this](std::size_t k, std::size_t i, std::size_t j) {
          const Terms& t = m_terms[k];
          return Scalar(t.inertia + t.viscosity * t.gradients[i].dot(t.gradients[j]));
        },
        m_of_cells.nodal);
    if (m_of_cells.coupling.rows() > 0)
      m_rows_of_vertices.template sum<3, 3>(
          m_for_each, m_vertices,
          [this](std::size_t k, std::size_t i, std::size_t j) {
            const Terms& t = m_terms[k];
            return Eigen::Matrix3d(t.viscosity * t.gradients[j] * t.gradients[i].transpose());
          },
          m_of_cells.coupling);
    m_rows_of_pressures.template sum<1, 3>(
        m_for_each, m_vertices,
        [this](std::size_t k, std::size_t, std::size_t j) {
          return Eigen::RowVector3d(m_terms[k].changes[j].transpose() / Mesh::corners);
        },
        m_of_cells.b);
    m_rows_of_pressures.template sum<1, 1>(
        m_for_each, m_pressures,
        [this](std::size_t k, std::size_t i, std::size_t j) {
          const Terms& t = m_terms[k];
          return Scalar(t.stabilization * t.gradients[i].dot(t.gradients[j]));
        },
        m_system.c);

    for (std::size_t v = 0; v < m_masses.size(); ++v)
      m_of_cells.nodal.coeffRef(Eigen::Index(v), Eigen::Index(v)) +=
          (1 - Mesh::part_at_middle) * rate(m_masses[v]);
    m_system.nodal = m_slips.symmetric<1>(m_of_cells.nodal);
    m_system.coupling = m_slips.symmetric<3>(m_of_cells.coupling);
    m_system.b = m_slips.columns<3>(m_of_cells.b);
    m_system.inertia = Vector::Zero(Eigen::Index(m_masses.size()));
    const std::vector<double> masses = masses_of_unknowns();
    for (std::size_t v = 0; v < m_masses.size(); ++v)
      m_system.inertia(Eigen::Index(v)) = rate(masses[v]);
    m_system.viscosity = Vector::Zero(m_system.c.rows());
    Vector volumes = m_system.viscosity;
    for (std::size_t k = 0; k < m_mesh.cells.size(); ++k)
      for (auto p : m_mesh.cells[k].pressures) {
        volumes(p) += m_elements[k].lumped_mass();
        m_system.viscosity(p) += m_viscosities[k] * m_elements[k].lumped_mass();
      }
    // The volume of a pressure whose cells are all flat can be 0.
    m_system.viscosity =
        (volumes.array() > 0).select(m_system.viscosity.array() / volumes.array().square(), 0.);
    m_forces = m_pushes = Vector::Zero(3 * Eigen::Index(m_masses.size()));
    for (std::size_t f = 0; f < m_mesh.facets.size(); ++f) {
      const auto& facet = m_mesh.facets[f];
      add_facet(facet, midpoint_positions, tension_of(f));
      if (facet.friction > 0)
        add_friction(facet, midpoint_positions);
      if (facet.gas != Mesh::no_gas)
        add_push(facet, midpoint_positions, gas_pressures[facet.gas]);
    }
  }

  // Adds forces on the vertices of each liquid to the forces of gases.
  void add_pushes(Vector forces) {
    m_slips.transform_forces(forces);
    m_pushes += forces;
  }

  // Returns the number of cells that are too flat to have gradients, both at the beginning and at
  // the midpoint. These cells have mass and volume, but neither viscosity nor stabilization.
  std::size_t number_of_flat_cells() const {
    return std::size_t(
        std::count_if(m_terms.begin(), m_terms.end(), [](const Terms& t) { return t.is_flat; }));
  }

  // Returns the system without constraints. The caller sets `constrained` and `closed`.
  const System& system() const { return m_system; }

  // Returns the forces of gases, and those of `add_pushes()`, on vertices.
  const Vector& pushes() const { return m_pushes; }

  // Returns f for the velocities of liquids at the beginning.
  Vector forces(const Vectors_3& velocities) const {
    Vector result = Vector::Zero(m_forces.size());
    for (std::size_t v = 0; v < m_masses.size(); ++v)
      at(result, v) +=
          (1 - Mesh::part_at_middle) * rate(m_masses[v]) * velocities[v] + m_masses[v] * m_gravity;
    for (std::size_t k = 0; k < m_mesh.cells.size(); ++k) {
      const Eigen::Vector3d share =
          Mesh::part_at_middle * rate(share_of_mass(k)) * m_mesh.middle(k, velocities);
      for (auto v : m_mesh.cells[k].vertices)
        at(result, v) += share;
    }
    m_slips.transform_forces(result);
    return result + m_forces + m_pushes;
  }

  // Returns s for the accelerations of vertices.
  Vector stabilization(const Vectors_3& accelerations) const {
    Vector result = Vector::Zero(m_system.c.rows());
    for (std::size_t k = 0; k < m_mesh.cells.size(); ++k) {
      const auto& cell = m_mesh.cells[k];
      const Eigen::Vector3d force =
          cell.liquid->density * (m_gravity - m_mesh.middle(k, accelerations));
      for (std::size_t i = 0; i < Mesh::corners; ++i)
        result(cell.pressures[i]) += m_terms[k].stabilization * m_terms[k].gradients[i].dot(force);
    }
    return result;
  }

  // Returns q for the volume that each cell gains in a unit of time.
  Vector sources(const std::vector<double>& gains) const {
    Vector result = Vector::Zero(m_system.c.rows());
    for (std::size_t k = 0; k < gains.size(); ++k)
      for (auto p : m_mesh.cells[k].pressures)
        result(p) += gains[k] / Mesh::corners;
    return result;
  }

  static Eigen::Ref<Eigen::Vector3d> at(Vector& vector, std::size_t v) {
    return vector.segment<3>(3 * Eigen::Index(v));
  }

private:
  // Returns the force that changes the velocity of a mass by 1 in the time theta dt.
  double rate(double mass) const { return mass / (m_step.theta * m_step.dt); }
  double share_of_mass(std::size_t k) const {
    return m_mesh.cells[k].liquid->density * m_elements[k].lumped_mass();
  }

  using Element = Linear_element<Complex>;

  // Returns the viscosity of a cell. The gradient of the velocity is computed with the vertices at
  // their positions at the beginning.
  double viscosity(std::size_t k, const Vectors_3& velocities) const {
    const auto& cell = m_mesh.cells[k];
    if (!cell.liquid->viscosity_at_shear_rate)
      return cell.liquid->viscosity;
    Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
    if (has_gradients<Complex>(m_elements[k], m_mesh.corners_at(cell.vertices, m_positions)))
      for (std::size_t i = 0; i < Mesh::corners; ++i)
        gradient +=
            velocities[cell.vertices[i]] * eigen_vector(m_elements[k].gradient(int(i))).transpose();
    const Eigen::Matrix3d d = (gradient + gradient.transpose()) / 2;
    const double shear_rate = std::sqrt(2 * d.squaredNorm()),
                 result = cell.liquid->viscosity_at_shear_rate(shear_rate);
    if (!(result >= 0) || !std::isfinite(result))
      throw Error("the viscosity at a shear rate of " + std::to_string(shear_rate) +
                  " is negative or not finite: bound the function for small and large shear rates");
    return result;
  }

  // The contributions of a cell to matrices, see `assemble()`.
  struct Terms
  {
    // Gradients of the basis functions, and of the volume of the cell.
    std::array<Eigen::Vector3d, Mesh::corners> gradients, changes;
    double inertia, viscosity, stabilization;
    bool is_flat; // all gradients of basis functions are 0
  };

  // Returns the contributions of a cell. Gradients are those at the midpoint, or those at the
  // beginning if the predicted cell is flat.
  Terms terms(std::size_t k, const Vectors_3& midpoint_positions) const {
    // The time in which the stabilization smooths pressures, as a fraction of the step.
    static constexpr double part = .05;
    static constexpr double viscous = 12; // factor of Hughes and others, for h^2 / viscosity
    static constexpr double flat = .1;    // relative to the volume at the beginning
    const auto& cell = m_mesh.cells[k];
    const auto corners = m_mesh.corners_at(cell.vertices, midpoint_positions);
    const Element moved = cell_element<Complex>(corners);
    const bool uses_moved =
        moved.measure() > flat * m_elements[k].measure() && has_gradients<Complex>(moved, corners);
    const Element& e = uses_moved ? moved : m_elements[k];
    Terms result;
    result.inertia = Mesh::part_at_middle / Mesh::corners * rate(share_of_mass(k));
    for (std::size_t i = 0; i < Mesh::corners; ++i)
      result.changes[i] = eigen_vector(moved.measure_gradient(int(i)));
    result.is_flat =
        !uses_moved && !has_gradients<Complex>(e, m_mesh.corners_at(cell.vertices, m_positions));
    if (result.is_flat) {
      result.gradients.fill(Eigen::Vector3d::Zero());
      result.viscosity = result.stabilization = 0;
      return result;
    }
    double steepest = 0; // the inverse square of the least height
    for (std::size_t i = 0; i < Mesh::corners; ++i) {
      result.gradients[i] = eigen_vector(e.gradient(int(i)));
      steepest = (std::max)(steepest, result.gradients[i].squaredNorm());
    }
    result.viscosity = e.measure() * m_viscosities[k];
    result.stabilization = e.measure() / (cell.liquid->density / (part * m_step.dt) +
                                          viscous * m_viscosities[k] * steepest);
    return result;
  }

  // Adds the force of a gas on a facet.
  void add_push(const typename Mesh::Facet& facet, const Vectors_3& midpoint_positions,
                double pressure) {
    const Eigen::Vector3d share =
        (facet.is_gas_in_front ? -1 : 1) * pressure / Mesh::dimension *
        area_vector(m_mesh.corners_at(facet.vertices, midpoint_positions));
    for (auto corner : facet.vertices)
      at(m_pushes, corner) += share;
  }

  // Adds the surface tension of a facet. Negative tensions of wetted walls would make the matrix
  // indefinite, so they are explicit forces at the midpoint.
  void add_facet(const typename Mesh::Facet& facet, const Vectors_3& midpoint_positions,
                 double tension) {
    if (tension == 0)
      return;
    static constexpr std::size_t n = Mesh::dimension;
    using Point = typename Complex::Point;
    const auto at_midpoint = m_mesh.corners_at(facet.vertices, midpoint_positions);
    const auto from = tension > 0 ? m_mesh.corners_at(facet.vertices, m_positions) : at_midpoint;
    std::array<Point, n> corners;
    for (std::size_t i = 0; i < n; ++i)
      corners[i] = from_eigen<Point>(at_midpoint[i]);
    const Facet_tension<Mesh::dimension> forces(corners);
    for (std::size_t i = 0; i < forces.weights.size(); ++i) {
      const std::size_t v = facet.vertices[i], w = facet.vertices[(i + 1) % n];
      const double weight = tension * forces.weights[i],
                   implicit = tension > 0 ? m_step.theta * m_step.dt * weight : 0;
      const Eigen::Vector3d pull = weight * (from[(i + 1) % n] - from[i]);
      at(m_forces, v) += pull;
      at(m_forces, w) -= pull;
      for (const auto& [i, j] : {std::make_pair(v, w), std::make_pair(w, v)}) {
        m_system.inertia(Eigen::Index(i)) += implicit;
        m_system.nodal.coeffRef(i, i) += implicit;
        m_system.nodal.coeffRef(i, j) -= implicit;
      }
    }
  }

  // Adds the friction of two liquids on a facet. It acts on their relative velocities.
  void add_friction(const typename Mesh::Facet& facet, const Vectors_3& midpoint_positions) {
    const double share = facet.friction *
                         area_vector(m_mesh.corners_at(facet.vertices, midpoint_positions)).norm() /
                         Mesh::dimension;
    for (auto corner : facet.vertices)
      if (const auto second = m_slips.second(corner)) {
        const auto row = Eigen::Index(*second);
        m_system.inertia(row) += share;
        m_system.nodal.coeffRef(row, row) += share;
      }
  }

  std::vector<typename Rows::Corners> corners(typename Rows::Corners Mesh::Cell::*of_cell) const {
    std::vector<typename Rows::Corners> result;
    for (const auto& cell : m_mesh.cells)
      result.push_back(cell.*of_cell);
    return result;
  }

  const For_each_index& m_for_each;
  const Mesh& m_mesh;
  Eigen::Vector3d m_gravity;
  Step m_step;
  Vectors_3 m_positions;
  std::vector<typename Rows::Corners> m_vertices, m_pressures; // by cell
  Rows m_rows_of_vertices, m_rows_of_pressures;
  std::vector<double> m_masses; // by vertex
  Slip_transform m_slips;
  std::vector<Element> m_elements;   // at the beginning
  std::vector<Terms> m_terms;        // by cell
  std::vector<double> m_viscosities; // by cell
  struct Matrices
  {
    System::Matrix nodal, coupling, b;
  };
  Matrices m_of_cells; // for the velocities of liquids
  System m_system;
  Vector m_forces, m_pushes; // forces of surface tension, and of gases
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_STEPS_FLUID_EQUATIONS_H
