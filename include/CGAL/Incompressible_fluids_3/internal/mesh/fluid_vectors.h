// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_FLUID_VECTORS_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_FLUID_VECTORS_H

#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Linear_element.h>

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

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

// The positions of the corners of a simplex. On a torus, they are images next to each other.
template <std::size_t n> using Corners_3 = std::array<Eigen::Vector3d, n>;

// Returns the volume of a tetrahedron, or the area of a triangle in the plane.
inline double volume(const Corners_3<4>& p) {
  return (p[1] - p[0]).cross(p[2] - p[0]).dot(p[3] - p[0]) / 6;
}
inline double volume(const Corners_3<3>& p) { return (p[1] - p[0]).cross(p[2] - p[0]).z() / 2; }

// Returns the normal towards the front of a triangle, or of a segment in the plane, with its area
// or length as the length.
inline Eigen::Vector3d area_vector(const Corners_3<3>& p) {
  return (p[1] - p[0]).cross(p[2] - p[0]) / 2;
}
inline Eigen::Vector3d area_vector(const Corners_3<2>& p) {
  const Eigen::Vector3d along = p[1] - p[0];
  return {along.y(), -along.x(), 0};
}

// Returns the linear element of a cell with given positions of its corners.
template <class Complex>
Linear_element<Complex> cell_element(const Corners_3<std::size_t(Complex::corners)>& positions) {
  typename Linear_element<Complex>::Corners corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
    corners[i] = from_eigen<typename Complex::Point>(positions[i]);
  return Linear_element<Complex>(corners);
}

// Returns whether the gradients of the basis functions of a cell can be computed. The result does
// not depend on the unit of length.
template <class Complex>
bool has_gradients(const Linear_element<Complex>& e,
                   const Corners_3<std::size_t(Complex::corners)>& positions) {
  // The least volume, relative to the cube of the longest edge. A regular tetrahedron has 0.12.
  // In the plane, it is the least area, relative to the square, and a regular triangle has 0.43.
  // Gradients of basis functions are then at most about 1e5 times as steep as in a regular
  // tetrahedron, which double precision permits.
  static constexpr double flattest = 1e-6;
  double square = 0; // of the longest edge
  for (std::size_t i = 0; i < positions.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      square = (std::max)(square, (positions[i] - positions[j]).squaredNorm());
  return e.measure() > flattest * std::pow(square, .5 * Complex::dimension);
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_FLUID_VECTORS_H
