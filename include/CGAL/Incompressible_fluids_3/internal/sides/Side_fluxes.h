// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Incompressible_fluids_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SIDES_SIDE_FLUXES_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SIDES_SIDE_FLUXES_H

#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>
#include <CGAL/Incompressible_fluids_3/Side_behavior.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/Fluid_mesh.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/cell_element.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/fluid_vectors.h>
#include <CGAL/Incompressible_fluids_3/internal/sides/Open_sides.h>
#include <CGAL/Incompressible_fluids_3/internal/sides/side_velocities.h>

#include <Eigen/Core>

#include <cstddef>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The volumes that cells gain in a unit of time through sides of the domain: their corners at
// inlets and on open sides do not move with the liquid.
template <class Complex> struct Side_fluxes
{
  using Mesh = Fluid_mesh<Complex>;

  const Mesh& mesh;
  const Side_behaviors& behaviors;
  const Inflow_velocities& inflow;
  const Open_sides& open;
  const Vectors_3& positions;

  // Returns the volume that cell k gains by inflow at its corner i.
  double by_inflow(std::size_t k, std::size_t i) const {
    const std::size_t v = mesh.cells[k].vertices[i];
    return is_inflow(inflow, v) ? gain(k, i, *inflow[v]) : 0;
  }

  // Calls `f(gain, side)` for the gains of all cells by inflow.
  template <class Function> void for_each_inflow(const Function& f) const {
    for (std::size_t k = 0; k < mesh.cells.size() && !inflow.empty(); ++k)
      for (std::size_t i = 0; i < Mesh::corners; ++i)
        if (const std::size_t v = mesh.cells[k].vertices[i]; inflow[v])
          for_each_part(k, i, sides_of_inflow(v), *inflow[v], f);
  }

  // Calls `f(cell, vertex, gain, side)` for each gain of a cell through an open side.
  // \param of_liquid the velocity of the liquid at each vertex
  // \param of_vertices the velocity of each vertex
  template <class Function>
  void for_each_passage(const Vectors_3& of_liquid, const Vectors_3& of_vertices,
                        const Function& f) const {
    for (std::size_t k = 0; k < mesh.cells.size() && !open.empty(); ++k)
      for (std::size_t i = 0; i < Mesh::corners; ++i) {
        const std::size_t v = mesh.cells[k].vertices[i];
        if (open.sides(v) != 0 && !is_inflow(inflow, v))
          for_each_part(k, i, open.sides(v), of_liquid[v] - of_vertices[v],
                        [&](double gain, std::size_t side) { f(k, v, gain, side); });
      }
  }

private:
  // Returns the volume that cell k gains because its corner i does not move with the liquid: the
  // change that this motion would cause. `velocity` is the velocity of the liquid relative to the
  // corner.
  double gain(std::size_t k, std::size_t i, const Eigen::Vector3d& velocity) const {
    const auto cell = cell_element<Complex>(mesh.corners_at(mesh.cells[k].vertices, positions));
    return -velocity.dot(eigen_vector(cell.measure_gradient(int(i))));
  }

  // Calls `f(gain, side)` for the gains of cell k at its corner i through a set of sides. If the
  // corner is on several of these sides, the components of the relative velocity pass through their
  // sides.
  template <class Function>
  void for_each_part(std::size_t k, std::size_t i, Boundary_class::Bits sides,
                     const Eigen::Vector3d& velocity, const Function& f) const {
    for (std::size_t side = 0; side < behaviors.size(); ++side)
      if (sides >> side & 1) {
        const bool is_only = sides == 1u << side;
        const Eigen::Vector3d normal = normal_of_side(side);
        f(gain(k, i, is_only ? velocity : Eigen::Vector3d(velocity.dot(normal) * normal)), side);
      }
  }

  // Returns the sides with an inflow on which a vertex lies, as bits.
  Boundary_class::Bits sides_of_inflow(std::size_t v) const {
    unsigned result = 0;
    for (std::size_t side = 0; side < behaviors.size(); ++side)
      if (behaviors[side].inflow)
        result |= mesh.vertices[v]->boundary_class() & 1u << side;
    return Boundary_class::Bits(result);
  }
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SIDES_SIDE_FLUXES_H
