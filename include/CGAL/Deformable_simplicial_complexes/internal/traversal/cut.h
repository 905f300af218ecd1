// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TRAVERSAL_CUT_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TRAVERSAL_CUT_H

#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns whether cells around an end of the edge are missing, because the complex is a part of a
// larger complex. An operation on such an edge could change cells that are not in the part.
template <class Cell_handle> bool has_cut_end(Cell_handle c, int i, int j) {
  return Boundary_class::is_cut(c->vertex(i)->boundary_class()) ||
         Boundary_class::is_cut(c->vertex(j)->boundary_class());
}

// Returns whether cells around the cell are missing, because the complex is a part of a larger
// complex.
template <class Complex> bool is_at_cut(typename Complex::Cell_handle c) {
  for (int i = 0; i < Complex::corners; ++i)
    if (Boundary_class::is_cut(c->vertex(i)->boundary_class()))
      return true;
  return false;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TRAVERSAL_CUT_H
