// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Incompressible_fluids_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_SLIP_CHANGES_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_SLIP_CHANGES_H

#include <CGAL/Incompressible_fluids_3/internal/mesh/Fluid_mesh.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A change of a velocity of a mesh.
struct Velocity_change
{
  std::size_t vertex;
  Eigen::Vector3d velocity;
};

/*
Returns the changes of velocities where two liquids slip along each other. The vertex moves with
neither of them, so at the end of a step of length dt, it meets other particles than before. The
velocity of each liquid is interpolated on the interface, in the facet from which the particles
come. So the change is stable if no liquid slips by more than an edge in a step.

`moving` are the velocities with which the liquids move in the step, and `velocities` are those at
its end. `positions` are the positions at the end.
*/
template <class Mesh>
std::vector<Velocity_change> changes_by_slip(const Mesh& mesh, const Vectors_3& positions,
                                             const Vectors_3& moving, const Vectors_3& velocities,
                                             double dt) {
  using Index = typename Mesh::Index;
  std::vector<Velocity_change> result;
  if (mesh.slips.empty())
    return result;
  // The other corners of the facets around each vertex, by the first occurrences of vertices.
  static constexpr int others = Mesh::dimension - 1;
  std::vector<std::vector<std::array<Index, others>>> around(mesh.number_of_vertices());
  for (const auto& facet : mesh.facets)
    for (std::size_t i = 0; i < Mesh::dimension; ++i) {
      auto& corners = around[facet.vertices[i]].emplace_back();
      for (std::size_t k = 0; k < others; ++k)
        corners[k] = facet.vertices[(i + k + 1) % Mesh::dimension];
    }
  const Vectors_3 common = mesh.common(moving);
  for (const auto& slip : mesh.slips)
    for (Index v : {slip.first, slip.second}) {
      const Eigen::Vector3d shift = dt * (common[v] - moving[v]);
      if (shift.isZero(0))
        continue;
      double best = -std::numeric_limits<double>::infinity();
      Velocity_change change{v, Eigen::Vector3d::Zero()};
      for (const auto& corners : around[slip.first]) {
        Eigen::Matrix<double, 3, others> edges, differences;
        for (int k = 0; k < others; ++k) {
          const Index corner = corners[std::size_t(k)];
          const auto ends = mesh.corners_at(std::array<Index, 2>{slip.first, corner}, positions);
          edges.col(k) = ends[1] - ends[0];
          differences.col(k) = velocities[mesh.occurrence(corner, *mesh.labels[v])] - velocities[v];
        }
        // The coordinates of the shift in the facet, which minimize the distance to it.
        const Eigen::Matrix<double, others, 1> coordinates =
            (edges.transpose() * edges).ldlt().solve(edges.transpose() * shift);
        const double least = coordinates.minCoeff();
        if (!coordinates.allFinite() || !(least > best))
          continue;
        best = least;
        const Eigen::Matrix<double, others, 1> inside = coordinates.cwiseMax(0.);
        change.velocity = differences * inside / (std::max)(1., inside.sum());
      }
      if (change.velocity.allFinite())
        result.push_back(change);
    }
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_SLIP_CHANGES_H
