// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SIDES_SIDE_PASSAGE_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SIDES_SIDE_PASSAGE_H

#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Incompressible_fluids_3/Side_behavior.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/Fluid_mesh.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/fluid_vectors.h>
#include <CGAL/Incompressible_fluids_3/internal/sides/Open_sides.h>
#include <CGAL/Incompressible_fluids_3/internal/sides/side_velocities.h>

#include <Eigen/Dense>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A change of a velocity of a mesh, interpolated linearly in one of the simplices at the vertex:
// the one in which the least coordinate of the shift of the vertex is largest.
struct Velocity_change
{
  std::size_t vertex = 0;
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  double least = -std::numeric_limits<double>::infinity();

  // Considers a simplex. The columns are edges from the vertex, and differences of velocities.
  template <class Columns>
  void consider(const Columns& edges, const Columns& differences, const Eigen::Vector3d& shift) {
    using Coordinates = Eigen::Matrix<double, Columns::ColsAtCompileTime, 1>;
    // The coordinates of the shift in the simplex, which minimize the distance to it.
    const Coordinates coordinates =
        (edges.transpose() * edges).ldlt().solve(edges.transpose() * shift);
    if (!coordinates.allFinite() || !(coordinates.minCoeff() > least))
      return;
    least = coordinates.minCoeff();
    const Coordinates inside = coordinates.cwiseMax(0.);
    velocity = differences * inside / (std::max)(1., inside.sum());
  }
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
      Velocity_change change;
      change.vertex = v;
      for (const auto& corners : around[slip.first]) {
        Eigen::Matrix<double, 3, others> edges, differences;
        for (int k = 0; k < others; ++k) {
          const Index corner = corners[std::size_t(k)];
          const auto ends = mesh.corners_at(std::array<Index, 2>{slip.first, corner}, positions);
          edges.col(k) = ends[1] - ends[0];
          differences.col(k) = velocities[mesh.occurrence(corner, *mesh.labels[v])] - velocities[v];
        }
        change.consider(edges, differences, shift);
      }
      if (change.velocity.allFinite())
        result.push_back(change);
    }
  return result;
}

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

// Returns the normals of the surfaces of liquids at vertices, or zero inside liquids. Where a free
// surface ends at a vertex, the interfaces of two liquids have no effect.
template <class Mesh> Vectors_3 surface_normals(const Mesh& mesh, const Vectors_3& positions) {
  Vectors_3 free(positions.size(), Eigen::Vector3d::Zero()), common = free;
  for (const auto& facet : mesh.facets) {
    const Eigen::Vector3d area = area_vector(mesh.corners_at(facet.vertices, positions));
    const bool is_front =
        facet.is_free ? facet.is_gas_in_front : facet.label_behind < facet.label_in_front;
    for (auto v : facet.vertices)
      (facet.is_free ? free : common)[v] += is_front ? area : Eigen::Vector3d(-area);
  }
  for (std::size_t v = 0; v < free.size(); ++v)
    free[v] = (free[v].isZero(0) ? common : free)[v].normalized();
  for (const auto& slip : mesh.slips)
    free[slip.second] = free[slip.first];
  return free;
}

// The geometry of an open part of a side, for the vertices near it.
struct Passage
{
  const Side_behaviors& behaviors;
  const Open_sides& open;
  double time; // at which parts are open
  double edge; // the length of an edge
};

/*
Returns the displacements that keep vertices on the open sides and in front of them, if they would
otherwise move with the liquid from `positions` to `moved`.

A vertex on an open side stays on the side. Where a surface meets the side, the liquid that leaves
takes the vertex along the surface beyond the side, so the vertex returns along the surface. The
surface then moves as a material surface up to the side. A vertex that would come near an open side
on which it does not lie keeps a distance to it, and returns in the same way.
*/
template <class Mesh>
Vectors_3 returns_from_sides(const Mesh& mesh, const Passage& passage, const Vectors_3& positions,
                             const Vectors_3& moved) {
  // The distance to an open side below which a vertex that does not lie on the side slows down, in
  // edges. Edges of this length are collapsed at the next adaptation.
  static constexpr double clearance = .25;
  // The least square of the sine of the angle between the surface and the side. On a flatter
  // surface, the vertex returns along the normal of the side.
  static constexpr double flattest = .25;
  Vectors_3 result(positions.size(), Eigen::Vector3d::Zero());
  if (passage.open.empty())
    return result;
  const Vectors_3 normals = surface_normals(mesh, moved);
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
    for (std::size_t side = 0; side < passage.behaviors.size(); ++side) {
      const auto& pressure = passage.behaviors[side].pressure;
      const auto axis = Eigen::Index(side / 2);
      const Boundary_class::Bits sides = mesh.vertices[v]->boundary_class();
      const bool is_on_side = passage.open.sides(v) >> side & 1;
      if (!pressure || !std::isfinite(mesh.sides[side]) ||
          (!is_on_side && Boundary_class::fixes(sides, int(axis))))
        continue;
      const Eigen::Vector3d outward = normal_of_side(side);
      const auto distance = [&](const Eigen::Vector3d& p) {
        return outward[axis] * (mesh.sides[side] - p[axis]);
      };
      const double moved_to = distance(moved[v]),
                   kept = is_on_side ? 0
                                     : kept_distance(distance(positions[v]), moved_to,
                                                     clearance * passage.edge),
                   excess = kept - moved_to;
      if (!is_on_side) {
        Eigen::Vector3d foot = positions[v];
        foot[axis] = mesh.sides[side];
        if (!(excess > 0) || !pressure({foot.x(), foot.y(), foot.z()}, passage.time))
          continue;
      }
      Eigen::Vector3d normal = normals[v];
      for (int other = 0; other < 3; ++other)
        if (other != axis && Boundary_class::fixes(sides, other))
          normal[other] = 0;
      normal.normalize();
      Eigen::Vector3d along = outward;
      if (excess > 0 && normal.allFinite() && !normal.isZero(0))
        along -= outward.dot(normal) * normal;
      if (along.dot(outward) < flattest)
        along = outward;
      result[v] -= excess / along.dot(outward) * along;
    }
  for (const auto& slip : mesh.slips)
    result[slip.second] = result[slip.first];
  return result;
}

// Returns the changes of velocities at vertices that do not move with the liquid, but have the
// displacement `shifts[v]` from it. `moved` are the positions of vertices that would move with the
// liquid, and `velocities` are linear in the cells between these positions. Where liquid enters,
// the shift points out of all cells, and the velocity does not change.
template <class Mesh>
std::vector<Velocity_change> changes_by_shifts(const Mesh& mesh, const Vectors_3& moved,
                                               const Vectors_3& shifts,
                                               const Vectors_3& velocities) {
  static constexpr int others = Mesh::corners - 1;
  std::vector<Velocity_change> of_vertices(moved.size());
  for (const auto& cell : mesh.cells)
    for (std::size_t i = 0; i < Mesh::corners; ++i) {
      const std::size_t v = cell.vertices[i];
      if (shifts[v].isZero(0))
        continue;
      Eigen::Matrix<double, 3, others> edges, differences;
      for (int k = 0; k < others; ++k) {
        const std::size_t corner = cell.vertices[(i + std::size_t(k) + 1) % Mesh::corners];
        edges.col(k) = moved[corner] - moved[v];
        differences.col(k) = velocities[corner] - velocities[v];
      }
      of_vertices[v].vertex = v;
      of_vertices[v].consider(edges, differences, shifts[v]);
    }
  std::vector<Velocity_change> result;
  for (const Velocity_change& change : of_vertices)
    if (std::isfinite(change.least) && change.velocity.allFinite())
      result.push_back(change);
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SIDES_SIDE_PASSAGE_H
