// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_COMPONENT_MOMENTA_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_COMPONENT_MOMENTA_H

#include <CGAL/Incompressible_fluids_3/Fluid_report.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/Fluid_mesh.h>

#include <Eigen/Dense>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The momentum and the angular momentum about the origin. On a torus, the angular momentum has no
// meaning and is not used.
struct Momentum
{
  Eigen::Vector3d linear = Eigen::Vector3d::Zero(), angular = Eigen::Vector3d::Zero();
};

// The masses of a set of components, at vertices and at barycenters of cells, see
// `Fluid_mesh::part_at_middle`. Each vertex occurs once.
struct Masses
{
  std::vector<std::pair<std::size_t, double>> of_vertices, of_middles;
};

// Calls `f(mass, a, b)` for each mass, with the values of two fields at its place.
template <class Mesh, class Function>
void for_each_mass(const Mesh& mesh, const Masses& masses, const Vectors_3& a, const Vectors_3& b,
                   const Function& f) {
  for (const auto& [v, m] : masses.of_vertices)
    f(m, a[v], b[v]);
  for (const auto& [k, m] : masses.of_middles)
    f(m, mesh.middle(k, a), mesh.middle(k, b));
}

// Returns the masses of each set of components. The function `set_of` maps a component to its set.
// \pre No two sets share a vertex.
template <class Mesh, class SetOf>
std::vector<Masses> masses_of_sets(const Mesh& mesh, const Vectors_3& positions,
                                   std::size_t number_of_sets, const SetOf& set_of) {
  std::vector<Masses> result(number_of_sets);
  std::vector<double> masses(positions.size(), 0);
  std::vector<std::size_t> set_of_vertex(positions.size(), number_of_sets);
  for (std::size_t k = 0; k < mesh.cells.size(); ++k) {
    const auto& cell = mesh.cells[k];
    const std::size_t set = set_of(cell.component);
    const double mass = cell.liquid->density * volume(mesh.corners_at(cell.vertices, positions));
    result[set].of_middles.emplace_back(k, Mesh::part_at_middle * mass);
    for (auto v : cell.vertices) {
      masses[v] += (1 - Mesh::part_at_middle) * mass / Mesh::corners;
      set_of_vertex[v] = set;
    }
  }
  for (std::size_t v = 0; v < positions.size(); ++v)
    result[set_of_vertex[v]].of_vertices.emplace_back(v, masses[v]);
  return result;
}

// Returns the masses of the same vertices and cells, with the vertices at other positions.
template <class Mesh>
Masses masses_at(const Mesh& mesh, Masses masses, const Vectors_3& positions) {
  std::vector<double> of_vertices(positions.size(), 0);
  for (auto& [k, m] : masses.of_middles) {
    const auto& cell = mesh.cells[k];
    const double mass = cell.liquid->density * volume(mesh.corners_at(cell.vertices, positions));
    m = Mesh::part_at_middle * mass;
    for (auto v : cell.vertices)
      of_vertices[v] += (1 - Mesh::part_at_middle) * mass / Mesh::corners;
  }
  for (auto& [v, m] : masses.of_vertices)
    m = of_vertices[v];
  return masses;
}

// Returns the momenta of masses.
template <class Mesh>
Momentum momentum(const Mesh& mesh, const Masses& masses, const Vectors_3& positions,
                  const Vectors_3& velocities) {
  Momentum result;
  for_each_mass(mesh, masses, positions, velocities,
                [&](double m, const Eigen::Vector3d& p, const Eigen::Vector3d& v) {
                  result.linear += m * v;
                  result.angular += m * p.cross(v);
                });
  return result;
}

// Returns the balance of all liquids, without the energy of gases. The function `tension_of` is as
// in `Fluid_equations::assemble()`. On a torus, the angular momentum and the potential energy are
// 0.
template <class Mesh, class TensionOf>
Fluid_balance balance(const Mesh& mesh, const Fluid_properties& properties,
                      const Vectors_3& positions, const Vectors_3& velocities,
                      const TensionOf& tension_of) {
  Fluid_balance result;
  const Masses masses =
      masses_of_sets(mesh, positions, 1, [](std::uint32_t) { return std::size_t(0); }).front();
  const Eigen::Vector3d gravity(properties.gravity().data());
  const Momentum sum = momentum(mesh, masses, positions, velocities);
  const auto vector = [](const Eigen::Vector3d& v) {
    return Fluid_balance::Vector(v.x(), v.y(), v.z());
  };
  result.momentum = vector(sum.linear);
  if (!Mesh::is_periodic)
    result.angular_momentum = vector(sum.angular);
  for_each_mass(mesh, masses, positions, velocities,
                [&](double m, const Eigen::Vector3d& p, const Eigen::Vector3d& v) {
                  result.mass += m;
                  result.kinetic_energy += m * v.squaredNorm() / 2;
                  if (!Mesh::is_periodic)
                    result.potential_energy -= m * gravity.dot(p);
                });
  for (const auto& cell : mesh.cells)
    result.volume += volume(mesh.corners_at(cell.vertices, positions));
  for (std::size_t f = 0; f < mesh.facets.size(); ++f)
    result.surface_energy +=
        tension_of(f) * area_vector(mesh.corners_at(mesh.facets[f].vertices, positions)).norm();
  return result;
}

// The velocities of a rigid motion: the velocity at a point is linear + angular x (point - center).
struct Rigid_velocity
{
  Eigen::Vector3d center = Eigen::Vector3d::Zero(), linear = Eigen::Vector3d::Zero(),
                  angular = Eigen::Vector3d::Zero();

  Eigen::Vector3d at(const Eigen::Vector3d& p) const { return linear + angular.cross(p - center); }
};

// Returns the rigid motion by which masses have the given momenta. On a torus, it is a translation.
// Returns zero velocities if there is no mass.
template <class Mesh>
Rigid_velocity rigid_velocity(const Mesh& mesh, const Masses& masses, const Vectors_3& positions,
                              const Momentum& momentum) {
  Rigid_velocity result;
  double mass = 0;
  const auto for_each = [&](const auto& f) {
    for_each_mass(mesh, masses, positions, positions,
                  [&](double m, const Eigen::Vector3d& p, const Eigen::Vector3d&) { f(m, p); });
  };
  for_each([&](double m, const Eigen::Vector3d& p) {
    mass += m;
    result.center += m * p;
  });
  if (!(mass > 0))
    return result;
  result.linear = momentum.linear / mass;
  if (Mesh::is_periodic)
    return result;
  result.center /= mass;
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  for_each([&](double m, const Eigen::Vector3d& p) {
    const Eigen::Vector3d r = p - result.center;
    inertia += m * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
  });
  result.angular = inertia.completeOrthogonalDecomposition().solve(
      momentum.angular - result.center.cross(momentum.linear));
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_COMPONENT_MOMENTA_H
