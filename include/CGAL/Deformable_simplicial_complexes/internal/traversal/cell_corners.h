// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TRAVERSAL_CELL_CORNERS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TRAVERSAL_CELL_CORNERS_H

#include <CGAL/Origin.h>

#include <array>

namespace CGAL::Deformable_simplicial_complexes::internal {

template <class Complex> using Cell_corners = std::array<typename Complex::Point, Complex::corners>;

// Returns the positions of the vertices of a finite cell. In a periodic domain, the images nearest
// to `near` are returned.
template <class Complex>
Cell_corners<Complex> cell_corners(const Complex& complex, typename Complex::Cell_handle c,
                                   const typename Complex::Point& nearby) {
  Cell_corners<Complex> result;
  for (int i = 0; i < Complex::corners; ++i)
    result[i] = complex.position_near(nearby, c->vertex(i));
  return result;
}

// Returns the positions of the vertices of a finite cell. In a periodic domain, the images nearest
// to the first vertex are returned.
template <class Complex>
Cell_corners<Complex> cell_corners(const Complex& complex, typename Complex::Cell_handle c) {
  return cell_corners(complex, c, complex.position(c->vertex(0)));
}

// Returns the barycenter of a cell, as seen from its vertex 0.
template <class Complex>
typename Complex::Point barycenter(const Complex& complex, typename Complex::Cell_handle c) {
  typename Complex::Vector sum(NULL_VECTOR);
  for (int i = 0; i < Complex::corners; ++i)
    sum = sum + (complex.corner(c, i) - ORIGIN);
  return ORIGIN + sum / Complex::corners;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TRAVERSAL_CELL_CORNERS_H
