// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Incompressible_fluids_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_CELL_ELEMENT_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_CELL_ELEMENT_H

#include <CGAL/Deformable_simplicial_complexes/Linear_element.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/Fluid_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the linear element of a cell with given positions of its corners.
template <class Complex>
Linear_element<Complex>
cell_element(const Corners_3<std::size_t(Fluid_mesh<Complex>::corners)>& positions) {
  typename Linear_element<Complex>::Corners corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
    corners[i] = from_eigen<typename Complex::Approximate_point>(positions[i]);
  return Linear_element<Complex>(corners);
}

// Returns whether the gradients of the basis functions of a cell can be computed. The result does
// not depend on the unit of length.
template <class Complex>
bool has_gradients(const Linear_element<Complex>& e,
                   const Corners_3<std::size_t(Fluid_mesh<Complex>::corners)>& positions) {
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

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_CELL_ELEMENT_H
