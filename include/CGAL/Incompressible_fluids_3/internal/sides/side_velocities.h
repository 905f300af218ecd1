// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SIDES_SIDE_VELOCITIES_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SIDES_SIDE_VELOCITIES_H

#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Incompressible_fluids_3/Side_behavior.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/fluid_vectors.h>
#include <CGAL/Incompressible_fluids_3/internal/sides/Open_sides.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the distance that a vertex keeps from a line or plane that it must not pass. Without the
// bound, the distance would change from `before` to `after`. Distances from -infinity to `near` are
// mapped to distances from near / 2 to `near`, so vertices one behind another keep their order. A
// vertex that was nearer does not come nearer.
inline double kept_distance(double before, double after, double nearby) {
  return after < nearby
             ? (std::min)(nearby / 2 * (1 + std::exp(2 * (after - nearby) / nearby)), before)
             : after;
}

// The velocities of vertices at which liquid enters through sides of the domain. The list is empty
// if no side has an inflow.
using Inflow_velocities = std::vector<std::optional<Eigen::Vector3d>>;

// Returns the velocity at a vertex on a no-slip side. If several sides meet there, it is that of
// the first one, in the order of `Boundary_class`. Components that leave a side are 0.
template <class Mesh>
std::optional<Eigen::Vector3d> no_slip_velocity(const Mesh& mesh, const Side_behaviors& behaviors,
                                                std::size_t v) {
  const auto sides = mesh.vertices[v]->boundary_class();
  for (std::size_t side = 0; side < behaviors.size(); ++side)
    if (behaviors[side].velocity && sides >> side & 1) {
      Eigen::Vector3d result(behaviors[side].velocity->data());
      for (int axis = 0; axis < 3; ++axis)
        if (axis >= Mesh::dimension || Boundary_class::fixes(sides, axis))
          result[axis] = 0;
      return result;
    }
  return std::nullopt;
}

// Returns the velocities of inflow at a time, with the vertices at given positions. Where several
// sides with an inflow meet, the first one determines the velocity.
// \throws Error if a velocity is not finite
template <class Mesh>
Inflow_velocities inflow_velocities(const Mesh& mesh, const Side_behaviors& behaviors,
                                    const Vectors_3& positions, double time) {
  Inflow_velocities result;
  for (std::size_t side = 0; side < behaviors.size(); ++side) {
    if (!behaviors[side].inflow)
      continue;
    result.resize(positions.size());
    for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
      if (result[v] || !(mesh.vertices[v]->boundary_class() >> side & 1))
        continue;
      const Eigen::Vector3d& p = positions[v];
      if (const auto velocity = behaviors[side].inflow({p.x(), p.y(), p.z()}, time)) {
        result[v] = Eigen::Vector3d(velocity->data());
        if (Mesh::dimension == 2)
          result[v]->z() = 0;
        if (!result[v]->allFinite())
          throw Error("a velocity of an inflow is not finite: return finite coordinates");
      }
    }
  }
  for (const auto& slip : mesh.slips)
    if (!result.empty())
      result[slip.second] = result[slip.first];
  return result;
}

// Returns whether liquid enters at a vertex.
inline bool is_inflow(const Inflow_velocities& inflow, std::size_t v) {
  return !inflow.empty() && inflow[v];
}

// The coordinates of a velocity that sides of the domain prescribe.
using Prescribed_coordinates = std::array<std::optional<double>, 3>;

// Returns the coordinates that sides prescribe at an open vertex. Walls that meet the open side
// keep their conditions. On a no-slip side that is open, the velocity along the side is prescribed,
// except where a surface of a liquid ends.
template <class Mesh>
Prescribed_coordinates coordinates_at_open_vertex(const Mesh& mesh, const Side_behaviors& behaviors,
                                                  Boundary_class::Bits open, std::size_t v) {
  const auto closed = Boundary_class::Bits(mesh.vertices[v]->boundary_class() & ~open);
  Prescribed_coordinates result;
  for (int axis = 0; axis < Mesh::dimension; ++axis) {
    if (Boundary_class::fixes(closed, axis))
      result[std::size_t(axis)] = 0;
    for (const bool is_open : {false, true})
      for (std::size_t side = 0; side < behaviors.size(); ++side)
        if (!result[std::size_t(axis)] && behaviors[side].velocity &&
            ((is_open ? open : closed) >> side & 1) &&
            (!is_open || (!Boundary_class::fixes(open, axis) && !mesh.is_on_interface[v])))
          result[std::size_t(axis)] = (*behaviors[side].velocity)[std::size_t(axis)];
  }
  return result;
}

// Sets the components of vectors to 0 that leave the sides of the domain. The open sides are an
// exception.
template <class Mesh>
void keep_on_closed_sides(const Mesh& mesh, const Open_sides& open, Vectors_3& vectors) {
  const Vectors_3 before = vectors;
  mesh.keep_on_sides(vectors);
  for (std::size_t v = 0; v < vectors.size() && !open.empty(); ++v)
    for (int axis = 0; axis < Mesh::dimension; ++axis)
      if (Boundary_class::fixes(open.sides(v), axis) &&
          !Boundary_class::fixes(
              Boundary_class::Bits(mesh.vertices[v]->boundary_class() & ~open.sides(v)), axis))
        vectors[v][axis] = before[v][axis];
}

// Replaces velocities of vertices on sides of the domain by those that the sides permit.
template <class Mesh>
void stop_on_sides(const Mesh& mesh, const Side_behaviors& behaviors,
                   const Inflow_velocities& inflow, const Open_sides& open, Vectors_3& velocities) {
  const Vectors_3 before = velocities;
  for (std::size_t v = 0; v < velocities.size(); ++v)
    if (const auto velocity = no_slip_velocity(mesh, behaviors, v))
      velocities[v] = *velocity;
  mesh.keep_on_sides(velocities);
  for (std::size_t v = 0; v < velocities.size() && !open.empty(); ++v)
    if (const auto sides = open.sides(v)) {
      velocities[v] = before[v];
      const auto prescribed = coordinates_at_open_vertex(mesh, behaviors, sides, v);
      for (std::size_t axis = 0; axis < prescribed.size(); ++axis)
        if (prescribed[axis])
          velocities[v][Eigen::Index(axis)] = *prescribed[axis];
    }
  for (std::size_t v = 0; v < inflow.size(); ++v)
    if (inflow[v])
      velocities[v] = *inflow[v];
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SIDES_SIDE_VELOCITIES_H
