// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Incompressible_fluids_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_WALLS_SLIP_FLUX_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_WALLS_SLIP_FLUX_H

#include <CGAL/Incompressible_fluids_3/Saddle_point_system.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/Fluid_mesh.h>
#include <CGAL/Incompressible_fluids_3/internal/walls/Wall_contacts.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

/*
The correction of the volume constraints where a liquid slips along a smooth surface, either a wall
or another liquid. A liquid that slides along the surface does not pass through it. However, the
facets of the mesh are chords of a curved surface: if the liquid slides at a vertex, it passes
through them, and a pressure that is not constant pushes it along the surface. This is the part of
the gradients of volumes in the integral over the facets,

   integral of phi_i phi_v n,   projected onto the free directions of the vertex v.

The correction removes this part for velocities relative to the surface. Then a liquid at rest under
gravity stays at rest in a slippery bowl, and a rotating liquid does not move the liquid around it.
*/
template <class Complex> class Slip_flux
{
public:
  using System = Saddle_point_system;
  using Mesh = Fluid_mesh<Complex>;

  // Computes the correction for constrained unknowns, with the vertices at given positions.
  Slip_flux(const Mesh& mesh, const Wall_contacts<Complex>& contacts,
            const std::vector<System::Constrained_velocity>& constrained,
            const Vectors_3& positions)
      : m_mesh(mesh), m_positions(positions), m_projections(positions.size(), nullptr),
        m_wall_velocities(System::Vector::Zero(3 * Eigen::Index(positions.size()))),
        m_matrix(Eigen::Index(mesh.vertex_of_pressure.size()), m_wall_velocities.size()) {
    for (const auto& c : constrained)
      m_projections[std::size_t(c.vertex)] = &c.projection;
    contacts.for_each_slip([&](std::size_t f, std::size_t v, const Eigen::Vector3d& wall_velocity) {
      m_wall_velocities.segment<3>(3 * Eigen::Index(v)) = wall_velocity;
      add(mesh.facets[f], mesh.facets[f].is_gas_in_front, v, v, 1);
    });
    std::vector<const typename Mesh::Slip*> slips(positions.size(), nullptr);
    for (const auto& slip : mesh.slips)
      slips[slip.first] = &slip;
    for (const auto& facet : mesh.facets)
      for (auto v : facet.vertices)
        if (const auto* slip = slips[v])
          for (const bool is_behind : {true, false}) {
            const bool is_first = is_behind == mesh.is_first_behind(facet);
            add(facet, is_behind, v, slip->second, is_first ? slip->share : slip->share - 1);
          }
    m_matrix.setFromTriplets(m_entries.begin(), m_entries.end());
    m_entries.clear();
  }

  bool is_zero() const { return m_matrix.nonZeros() == 0; }

  // Returns the matrix to be added to the matrix b of a system.
  const System::Matrix& matrix() const { return m_matrix; }

  // Returns the volumes that the correction adds for the motion of walls.
  System::Vector of_walls() const { return m_matrix * m_wall_velocities; }

private:
  // Adds the terms of a facet and a vertex v for the liquid on one side of the facet. The velocity
  // of the liquid along the facet is `factor` times the unknown at a place.
  void add(const typename Mesh::Facet& facet, bool is_behind, std::size_t v, std::size_t place,
           double factor) {
    // The integral of phi_i phi_v over a facet is its area, divided by this number, and twice as
    // large if i and v are the same.
    static constexpr int products = Complex::dimension * (Complex::dimension + 1);
    if (m_projections[place] == nullptr)
      return;
    const Eigen::Vector3d outward =
        (is_behind ? factor : -factor) * area_vector(facet.vertices, m_positions);
    const Eigen::Vector3d along = *m_projections[place] * outward;
    const int label = is_behind ? facet.label_behind : facet.label_in_front;
    for (auto i : facet.vertices) {
      const auto p = m_mesh.pressure(m_mesh.occurrence(i, label), label);
      for (int axis = 0; axis < 3; ++axis)
        m_entries.emplace_back(int(p), 3 * int(place) + axis,
                               -(i == v ? 2 : 1) * along[axis] / products);
    }
  }

  const Mesh& m_mesh;
  const Vectors_3& m_positions;
  std::vector<const Eigen::Matrix3d*> m_projections; // by place; null if all directions are free
  System::Vector m_wall_velocities;                  // by vertex, where the matrix is not zero
  System::Matrix m_matrix;
  std::vector<Eigen::Triplet<double>> m_entries;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_WALLS_SLIP_FLUX_H
