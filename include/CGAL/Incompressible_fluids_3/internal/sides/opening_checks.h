// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Incompressible_fluids_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SIDES_OPENING_CHECKS_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SIDES_OPENING_CHECKS_H

#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Incompressible_fluids_3/Side_behavior.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/fluid_vectors.h>
#include <CGAL/Incompressible_fluids_3/internal/sides/Open_sides.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns whether liquid may pass through a side.
inline bool have_openings(const Side_behaviors& behaviors) {
  return std::any_of(behaviors.begin(), behaviors.end(),
                     [](const Side_behavior& side) { return side.inflow || side.pressure; });
}

// Returns a mask for boundary classes. It clears the sides through which liquid may pass.
inline Boundary_class::Bits sides_without_openings(const Side_behaviors& behaviors) {
  unsigned result = (std::numeric_limits<Boundary_class::Bits>::max)();
  for (std::size_t side = 0; side < behaviors.size(); ++side)
    if (behaviors[side].inflow || behaviors[side].pressure)
      result &= ~(1u << side);
  return Boundary_class::Bits(result);
}

// Throws an exception if liquid cannot pass through an inlet or an open part of a side at a time,
// because the part contains points of the surface of the liquid but no vertex. Parts smaller than
// a tenth of an edge may remain undetected.
// \throws Error if there is such a part
template <class Mesh>
void require_vertices_in_openings(const Mesh& mesh, const Side_behaviors& behaviors,
                                  const Vectors_3& positions, double time) {
  static constexpr int parts = 10; // of an edge
  std::array<bool, 6> has_vertex = {}, has_point = {};
  const auto is_in = [&](std::size_t side, const Eigen::Vector3d& p) {
    const std::array<double, 3> at = {p.x(), p.y(), p.z()};
    return (behaviors[side].inflow && behaviors[side].inflow(at, time)) ||
           (behaviors[side].pressure && behaviors[side].pressure(at, time));
  };
  for (std::size_t side = 0; side < behaviors.size(); ++side) {
    if (!behaviors[side].inflow && !behaviors[side].pressure)
      continue;
    for (std::size_t v = 0; v < mesh.number_of_vertices() && !has_vertex[side]; ++v)
      has_vertex[side] =
          (mesh.vertices[v]->boundary_class() >> side & 1) != 0 && is_in(side, positions[v]);
  }
  for_each_side_facet(mesh, [&](std::size_t k, std::size_t corner, std::size_t side) {
    if (has_vertex[side] || has_point[side])
      return;
    std::array<Eigen::Vector3d, Mesh::dimension> corners;
    for (std::size_t i = 0, n = 0; i < Mesh::corners; ++i)
      if (i != corner)
        corners[n++] = positions[mesh.cells[k].vertices[i]];
    for (int i = 0; i <= parts; ++i)
      for (int j = 0; j <= (Mesh::dimension == 3 ? parts - i : 0); ++j)
        has_point[side] = has_point[side] ||
                          is_in(side, corners[0] + double(i) / parts * (corners[1] - corners[0]) +
                                          double(j) / parts * (corners.back() - corners[0]));
  });
  for (std::size_t side = 0; side < behaviors.size(); ++side)
    if (has_point[side])
      throw Error("the opening in the side of " +
                  std::string(side % 2 == 0 ? "smallest " : "largest ") + "xyz"[side / 2] +
                  " contains no vertex of a liquid: use shorter edges or a larger opening");
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SIDES_OPENING_CHECKS_H
