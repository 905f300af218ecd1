// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Incompressible_fluids_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_WALLS_WALL_FLUX_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_WALLS_WALL_FLUX_H

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
The correction of the volume constraints at slip walls. A liquid that slides along a smooth wall
passes through no wall. However, the facets of the mesh are chords of a curved wall: if a vertex
slides, the volumes around it change, and a pressure that is not constant pushes it along the wall.
This is the part of the gradients of volumes in the integral over the wetted facets,

   integral of phi_i phi_v n,   projected onto the free directions of the vertex v.

The correction removes this part for velocities relative to the wall. Then a liquid at rest under
gravity stays at rest in a slippery bowl.
*/
struct Wall_flux
{
  using System = Saddle_point_system;

  System::Matrix matrix;          // to be added to the matrix b of a system
  System::Vector wall_velocities; // by vertex, where the matrix is not zero

  // Computes the correction for constrained velocities, with the vertices at given positions.
  template <class Complex>
  Wall_flux(const Fluid_mesh<Complex>& mesh, const Wall_contacts<Complex>& contacts,
            const std::vector<System::Constrained_velocity>& constrained,
            const Vectors_3& positions)
      : wall_velocities(System::Vector::Zero(3 * Eigen::Index(positions.size()))) {
    std::vector<const Eigen::Matrix3d*> free(positions.size(), nullptr);
    for (const auto& c : constrained)
      free[std::size_t(c.vertex)] = &c.projection;
    // The integral of phi_i phi_v over a facet is its area, divided by this number, and twice as
    // large if i and v are the same.
    static constexpr int products = Complex::dimension * (Complex::dimension + 1);
    std::vector<Eigen::Triplet<double>> entries;
    contacts.for_each_slip([&](std::size_t f, std::size_t v, const Eigen::Vector3d& wall_velocity) {
      if (free[v] == nullptr)
        return;
      const auto& facet = mesh.facets[f];
      const Eigen::Vector3d along =
          (facet.is_gas_in_front ? 1 : -1) * *free[v] * area_vector(facet.vertices, positions);
      wall_velocities.segment<3>(3 * Eigen::Index(v)) = wall_velocity;
      for (auto i : facet.vertices) {
        const auto p =
            mesh.pressure(i, facet.is_gas_in_front ? facet.label_behind : facet.label_in_front);
        for (int axis = 0; axis < 3; ++axis)
          entries.emplace_back(int(p), 3 * int(v) + axis,
                               -(i == v ? 2 : 1) * along[axis] / products);
      }
    });
    matrix.resize(Eigen::Index(mesh.vertex_of_pressure.size()), wall_velocities.size());
    matrix.setFromTriplets(entries.begin(), entries.end());
  }

  bool is_zero() const { return matrix.nonZeros() == 0; }
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_WALLS_WALL_FLUX_H
