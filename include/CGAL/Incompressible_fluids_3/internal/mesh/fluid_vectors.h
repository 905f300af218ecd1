// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Incompressible_fluids_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_FLUID_VECTORS_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_FLUID_VECTORS_H

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Vectors have three coordinates in the plane, too. The third one is 0.
using Vectors_3 = std::vector<Eigen::Vector3d>;

// Returns the coordinates of a point or vector.
template <class Coordinates> Eigen::Vector3d eigen_vector(const Coordinates& p) {
  if constexpr (Coordinates::Ambient_dimension::value == 2)
    return {p[0], p[1], 0};
  else
    return {p[0], p[1], p[2]};
}

// Returns a point or vector with the given coordinates.
template <class Coordinates> Coordinates from_eigen(const Eigen::Vector3d& v) {
  if constexpr (Coordinates::Ambient_dimension::value == 2)
    return Coordinates(v.x(), v.y());
  else
    return Coordinates(v.x(), v.y(), v.z());
}

// Returns the volume of a tetrahedron, or the area of a triangle in the plane, with its vertices at
// the given positions.
template <class Index> double volume(const std::array<Index, 4>& v, const Vectors_3& positions) {
  const Eigen::Vector3d& o = positions[v[0]];
  return (positions[v[1]] - o).cross(positions[v[2]] - o).dot(positions[v[3]] - o) / 6;
}
template <class Index> double volume(const std::array<Index, 3>& v, const Vectors_3& positions) {
  const Eigen::Vector3d& o = positions[v[0]];
  return (positions[v[1]] - o).cross(positions[v[2]] - o).z() / 2;
}

// Returns the normal towards the front of a triangle, or of a segment in the plane, with its area
// or length as the length.
template <class Index>
Eigen::Vector3d area_vector(const std::array<Index, 3>& v, const Vectors_3& positions) {
  const Eigen::Vector3d& o = positions[v[0]];
  return (positions[v[1]] - o).cross(positions[v[2]] - o) / 2;
}
template <class Index>
Eigen::Vector3d area_vector(const std::array<Index, 2>& v, const Vectors_3& positions) {
  const Eigen::Vector3d along = positions[v[1]] - positions[v[0]];
  return {along.y(), -along.x(), 0};
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_FLUID_VECTORS_H
