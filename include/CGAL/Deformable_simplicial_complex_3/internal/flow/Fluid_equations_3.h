// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_FLOW_FLUID_EQUATIONS_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_FLOW_FLUID_EQUATIONS_3_H

#include <CGAL/Deformable_simplicial_complex_3/internal/flow/Fluid_mesh_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/geometry/Facet_tension.h>
#include <CGAL/Deformable_simplicial_complexes/internal/geometry/Linear_element.h>

#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

/*
The equations of a step of time dt of incompressible flow, by linear finite elements on tetrahedra
that go with the flow. Unknown are the velocities v at the time theta dt, by which vertices go from
x to x + dt v, and the pressures p:

   A v - B^T p = f,   A = M / (theta dt) + K + theta dt L,  f = M (u / (theta dt) + g) - L x + w
   B v + C p   = s

M are masses, see `Fluid_mesh_3`, K is viscosity, L x the gradient of the energy of surfaces, w that
of walls that are wet. Each row of B is the gradient of a quarter of the volume around a vertex, so
that B v = 0 keeps it. That alone permits pressures that nothing feels: C, which sums up to nothing,
is made of the residual of the equation of motion, and vanishes with it, where the gradient of p is
that of gravity less acceleration (T. J. R. Hughes, L. P. Franca, M. Balestra, "A new finite element
formulation for computational fluid dynamics: V.", 1986). Pressure is constant in no cell: with one
pressure for each cell, nothing would move that is not linear.
*/
template <class Complex> class Fluid_equations_3
{
public:
  using Mesh = Fluid_mesh_3<Complex>;
  using Matrix = Eigen::SparseMatrix<double>;
  using Vector = Eigen::VectorXd;

  // dt: step of time; theta: 1/2 for the implicit midpoint rule, 1 for Euler's backward one.
  struct Step
  {
    double dt, theta;
  };

  Fluid_equations_3(const Mesh& mesh, const Fluid_properties_3& properties, const Step& step,
                    const Vectors_3& positions)
      : m_mesh(mesh), m_gravity(properties.gravity().data()), m_step(step), m_positions(positions) {
    m_masses.assign(mesh.vertices.size(), 0);
    for (const auto& cell : mesh.cells) {
      m_elements.push_back(element(cell, positions));
      for (auto v : cell.vertices)
        m_masses[v] += cell.liquid->density * m_elements.back().lumped_mass();
    }
  }

  // Of vertices, a quarter of those of the cells around.
  const std::vector<double>& masses() const { return m_masses; }

  // The matrices with the vertices at some positions, about half-way. The energies of facets that
  // are wet are tensions in place of those of the mesh.
  template <class TensionOf> void assemble(const Vectors_3& half_way, const TensionOf& tension_of) {
    Entries a, b, c;
    b.reserve(48 * m_mesh.cells.size());
    c.reserve(16 * m_mesh.cells.size());
    for (std::size_t v = 0; v < m_masses.size(); ++v)
      add_block(a, v, v,
                (1 - Mesh::part_at_middle) * rate(m_masses[v]) * Eigen::Matrix3d::Identity());
    m_forces = Vector::Zero(3 * Eigen::Index(m_masses.size()));
    m_stabilization.clear();
    m_stiffness.assign(m_masses.size(), 0);
    for (std::size_t k = 0; k < m_mesh.cells.size(); ++k)
      add_cell(k, half_way, a, b, c);
    for (std::size_t f = 0; f < m_mesh.facets.size(); ++f)
      add_facet(m_mesh.facets[f], half_way, tension_of(f), a);
    const Eigen::Index n = m_forces.size(), m = Eigen::Index(m_mesh.vertex_of_pressure.size());
    m_a = Matrix(n, n);
    m_a.setFromTriplets(a.begin(), a.end());
    m_b = Matrix(m, n);
    m_b.setFromTriplets(b.begin(), b.end());
    m_c = Matrix(m, m);
    m_c.setFromTriplets(c.begin(), c.end());
  }

  const Matrix& a() const { return m_a; }
  const Matrix& b() const { return m_b; }
  const Matrix& c() const { return m_c; }
  // What multiplies velocities for the sake of masses and surfaces, and pressures for that of
  // viscosity; see `Saddle_point_system`.
  Vector inertia() const {
    Vector result(m_forces.size());
    for (std::size_t v = 0; v < m_masses.size(); ++v)
      at(result, v).setConstant(rate(m_masses[v]) + m_stiffness[v]);
    return result;
  }
  Vector viscosity() const {
    Vector viscosities = Vector::Zero(m_c.rows()), volumes = viscosities;
    for (std::size_t k = 0; k < m_mesh.cells.size(); ++k)
      for (auto p : m_mesh.cells[k].pressures) {
        volumes(p) += m_elements[k].lumped_mass();
        viscosities(p) = m_mesh.cells[k].liquid->viscosity;
      }
    return viscosities.cwiseQuotient(volumes);
  }

  // f
  Vector forces(const Vectors_3& velocities) const {
    Vector result = m_forces;
    for (std::size_t v = 0; v < m_masses.size(); ++v)
      at(result, v) +=
          (1 - Mesh::part_at_middle) * rate(m_masses[v]) * velocities[v] + m_masses[v] * m_gravity;
    for (std::size_t k = 0; k < m_mesh.cells.size(); ++k) {
      const Eigen::Vector3d share =
          Mesh::part_at_middle * rate(quarter_mass(k)) * m_mesh.middle(k, velocities);
      for (auto v : m_mesh.cells[k].vertices)
        at(result, v) += share;
    }
    return result;
  }

  // s, with the accelerations of vertices.
  Vector stabilization(const Vectors_3& accelerations) const {
    Vector result = Vector::Zero(m_c.rows());
    for (std::size_t k = 0; k < m_mesh.cells.size(); ++k) {
      const auto& cell = m_mesh.cells[k];
      const Eigen::Vector3d force =
          cell.liquid->density * (m_gravity - m_mesh.middle(k, accelerations));
      for (std::size_t i = 0; i < 4; ++i)
        result(cell.pressures[i]) += m_stabilization[k][i].dot(force);
    }
    return result;
  }

  static Eigen::Ref<Eigen::Vector3d> at(Vector& vector, std::size_t v) {
    return vector.segment<3>(3 * Eigen::Index(v));
  }

private:
  // What changes a velocity in the step by 1.
  double rate(double mass) const { return mass / (m_step.theta * m_step.dt); }
  double quarter_mass(std::size_t k) const {
    return m_mesh.cells[k].liquid->density * m_elements[k].lumped_mass();
  }

  using Entries = std::vector<Eigen::Triplet<double>>;
  using Element = Linear_element<Complex>;

  static typename Complex::Approximate_point point(const Eigen::Vector3d& p) {
    return {p.x(), p.y(), p.z()};
  }
  static Element element(const typename Mesh::Cell& cell, const Vectors_3& positions) {
    typename Element::Corners corners;
    for (std::size_t i = 0; i < 4; ++i)
      corners[i] = point(positions[cell.vertices[i]]);
    return Element(corners);
  }

  template <class Block>
  static void add_block(Entries& entries, std::size_t v, std::size_t w, const Block& block) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (block(i, j) != 0)
          entries.emplace_back(3 * Eigen::Index(v) + i, 3 * Eigen::Index(w) + j, block(i, j));
  }

  void add_cell(std::size_t k, const Vectors_3& half_way, Entries& a, Entries& b, Entries& c) {
    // Of a step: how much of its time the pressure needs to level out what it feels not.
    static constexpr double part = .05;
    static constexpr double viscous = 12; // Hughes and others: of h^2 / viscosity
    static constexpr double flat = .1;    // of the volume at the beginning
    const auto& cell = m_mesh.cells[k];
    const Element moved = element(cell, half_way);
    // A cell that the prediction makes flat is none to divide by.
    const Element& e = moved.measure() > flat * m_elements[k].measure() ? moved : m_elements[k];
    const double volume = e.measure(), viscosity = cell.liquid->viscosity;
    std::array<Eigen::Vector3d, 4> gradients;
    double steepest = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      gradients[i] = eigen_vector(e.gradient(int(i)));
      steepest = (std::max)(steepest, gradients[i].squaredNorm());
      const Eigen::Vector3d change = eigen_vector(moved.measure_gradient(int(i)));
      for (auto p : cell.pressures)
        for (int axis = 0; axis < 3; ++axis)
          b.emplace_back(p, 3 * Eigen::Index(cell.vertices[i]) + axis, change(axis) / 4);
    }
    // 1 / steepest is the square of the least height.
    const double tau =
        1 / (cell.liquid->density / (part * m_step.dt) + viscous * viscosity * steepest);
    m_stabilization.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) {
      m_stabilization.back()[i] = tau * volume * gradients[i];
      for (std::size_t j = 0; j < 4; ++j) {
        c.emplace_back(cell.pressures[i], cell.pressures[j],
                       tau * volume * gradients[i].dot(gradients[j]));
        add_block(a, cell.vertices[i], cell.vertices[j],
                  Mesh::part_at_middle / 4 * rate(quarter_mass(k)) * Eigen::Matrix3d::Identity());
        if (viscosity > 0)
          add_block(a, cell.vertices[i], cell.vertices[j],
                    viscosity * volume *
                        (gradients[i].dot(gradients[j]) * Eigen::Matrix3d::Identity() +
                         gradients[j] * gradients[i].transpose()));
      }
    }
  }

  // Tensions that are negative, of wet walls, are forces of now, as they would not be definite.
  void add_facet(const typename Mesh::Facet& facet, const Vectors_3& half_way, double tension,
                 Entries& a) {
    if (tension == 0)
      return;
    std::array<typename Complex::Approximate_point, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = point(half_way[facet.vertices[i]]);
    const Facet_tension<3> cotangents(corners);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t v = facet.vertices[i], w = facet.vertices[(i + 1) % 3];
      const double weight = tension * cotangents.weights[i],
                   implicit = tension > 0 ? m_step.theta * m_step.dt * weight : 0;
      const Vectors_3& from = tension > 0 ? m_positions : half_way;
      const Eigen::Vector3d pull = weight * (from[w] - from[v]);
      at(m_forces, v) += pull;
      at(m_forces, w) -= pull;
      m_stiffness[v] += implicit;
      m_stiffness[w] += implicit;
      if (implicit != 0)
        for (int axis = 0; axis < 3; ++axis) {
          const Eigen::Index i_v = 3 * Eigen::Index(v) + axis, i_w = 3 * Eigen::Index(w) + axis;
          a.emplace_back(i_v, i_v, implicit);
          a.emplace_back(i_w, i_w, implicit);
          a.emplace_back(i_v, i_w, -implicit);
          a.emplace_back(i_w, i_v, -implicit);
        }
    }
  }

  const Mesh& m_mesh;
  Eigen::Vector3d m_gravity;
  Step m_step;
  Vectors_3 m_positions;
  std::vector<Element> m_elements;           // at the beginning
  std::vector<double> m_masses, m_stiffness; // by vertex
  Matrix m_a, m_b, m_c;
  Vector m_forces;                                             // of surfaces
  std::vector<std::array<Eigen::Vector3d, 4>> m_stabilization; // by cell and corner
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_FLOW_FLUID_EQUATIONS_3_H
