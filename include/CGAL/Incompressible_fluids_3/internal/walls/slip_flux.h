// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_WALLS_SLIP_FLUX_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_WALLS_SLIP_FLUX_H

#include <CGAL/Incompressible_fluids_3/Saddle_point_system.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/Fluid_mesh.h>
#include <CGAL/Incompressible_fluids_3/internal/walls/Wall_contacts.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

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
struct Slip_flux
{
  Saddle_point_system::Matrix matrix;   // to be added to the matrix b of a system
  Saddle_point_system::Vector of_walls; // the volumes that the correction adds for moving walls
  std::vector<Body_equations::Flux> of_bodies; // the same for bodies, by their unknown velocities
};

// Computes the correction for constrained unknowns, with the vertices at given positions.
template <class Complex>
Slip_flux slip_flux(const Fluid_mesh<Complex>& mesh, const Wall_contacts<Complex>& contacts,
                    const std::vector<Saddle_point_system::Constrained_velocity>& constrained,
                    const Vectors_3& positions) {
  using Mesh = Fluid_mesh<Complex>;
  std::vector<const Eigen::Matrix3d*> projections(positions.size(), nullptr); // by unknown
  for (const auto& c : constrained)
    projections[std::size_t(c.vertex)] = &c.projection;
  const auto volumes = Eigen::Index(mesh.vertex_of_pressure.size());
  Slip_flux result{Saddle_point_system::Matrix(volumes, 3 * Eigen::Index(positions.size())),
                   Saddle_point_system::Vector::Zero(volumes),
                   {}};
  std::vector<Eigen::Triplet<double>> entries;

  // Adds the terms of a facet and a vertex v for the liquid on one side of the facet. The velocity
  // of the liquid along the facet is `factor` times an unknown, which is the velocity of the wall
  // if they move together.
  const auto add = [&](const typename Mesh::Facet& facet, bool is_behind, std::size_t v,
                       std::size_t unknown, double factor, const Eigen::Vector3d& of_wall,
                       const std::optional<Vertex_constraints::Attached_body>& body) {
    // The integral of phi_i phi_v over a facet is its area, divided by this number, and twice as
    // large if i and v are the same.
    static constexpr int products = Complex::dimension * (Complex::dimension + 1);
    if (projections[unknown] == nullptr)
      return;
    const Eigen::Vector3d outward =
        (is_behind ? factor : -factor) * area_vector(mesh.corners_at(facet.vertices, positions));
    const Eigen::Vector3d along = *projections[unknown] * outward;
    const int label = is_behind ? facet.label_behind : facet.label_in_front;
    for (auto i : facet.vertices) {
      const auto p = mesh.pressure(mesh.occurrence(i, label), label);
      const Eigen::Vector3d row = -(i == v ? 2 : 1) * along / products;
      for (int axis = 0; axis < 3; ++axis)
        entries.emplace_back(int(p), 3 * int(unknown) + axis, row[axis]);
      result.of_walls(p) += row.dot(of_wall);
      if (body)
        result.of_bodies.push_back({Eigen::Index(p), *body, -row});
    }
  };

  contacts.for_each_slip(
      [&](std::size_t f, std::size_t v, const Eigen::Vector3d& wall_velocity, const auto& body) {
        add(mesh.facets[f], mesh.facets[f].is_gas_in_front, v, v, 1, wall_velocity, body);
      });
  std::vector<const Slip*> slips(positions.size(), nullptr);
  for (const auto& slip : mesh.slips)
    slips[slip.first] = &slip;
  for (const auto& facet : mesh.facets) {
    const bool is_first_behind = mesh.is_first_behind(facet);
    for (auto v : facet.vertices)
      if (const auto* slip = slips[v])
        for (const bool is_behind : {true, false})
          add(facet, is_behind, v, slip->second,
              is_behind == is_first_behind ? slip->share : slip->share - 1, Eigen::Vector3d::Zero(),
              std::nullopt);
  }
  result.matrix.setFromTriplets(entries.begin(), entries.end());
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_WALLS_SLIP_FLUX_H
