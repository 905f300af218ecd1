// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_GEOMETRY_CELL_CORNERS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_GEOMETRY_CELL_CORNERS_H

#include <array>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Where the vertices of a finite cell are, as seen from the first.
template <class Complex>
std::array<typename Complex::Approximate_point_3, 4> cell_corners(const Complex& complex,
                                                                  typename Complex::Cell_handle c) {
  return {complex.corner(c, 0), complex.corner(c, 1), complex.corner(c, 2), complex.corner(c, 3)};
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_GEOMETRY_CELL_CORNERS_H
