// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_GEOMETRY_CELL_CORNERS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_GEOMETRY_CELL_CORNERS_H

#include <array>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

template <class Complex>
using Cell_corners = std::array<typename Complex::Approximate_point, Complex::corners>;

// Where the vertices of a finite cell are, as seen from a point near it.
template <class Complex>
Cell_corners<Complex> cell_corners(const Complex& complex, typename Complex::Cell_handle c,
                                   const typename Complex::Approximate_point& near) {
  Cell_corners<Complex> result;
  for (int i = 0; i < Complex::corners; ++i)
    result[i] = complex.position_near(near, c->vertex(i));
  return result;
}

// The same, as seen from its first vertex.
template <class Complex>
Cell_corners<Complex> cell_corners(const Complex& complex, typename Complex::Cell_handle c) {
  return cell_corners(complex, c, complex.position(c->vertex(0)));
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_GEOMETRY_CELL_CORNERS_H
