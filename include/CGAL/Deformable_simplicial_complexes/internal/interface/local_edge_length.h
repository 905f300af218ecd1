// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_LOCAL_EDGE_LENGTH_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_LOCAL_EDGE_LENGTH_H

#include <CGAL/Deformable_simplicial_complexes/star_union.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// What limits of lengths are measured by, so that they follow the mesh from place to place and as
// it is made finer or coarser, but not as motion stretches or shrinks it: what has become smaller
// than the edges that the user has chosen is to go.
template <class Complex>
double local_edge_length(const Complex& complex, typename Complex::Vertex_handle v) {
  return v->spacing() > 0 ? v->spacing() : complex.interface_edge_length(v);
}

// The mean of these lengths at those vertices of cells that are on the interface; 0 if none is.
template <class Complex>
double local_edge_length(const Complex& complex,
                         const std::vector<typename Complex::Cell_handle>& cells) {
  double sum = 0;
  std::size_t number = 0;
  for (auto v : vertices_of(complex, cells))
    if (v->is_interface()) {
      sum += local_edge_length(complex, v);
      ++number;
    }
  return number > 0 ? sum / double(number) : 0;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_LOCAL_EDGE_LENGTH_H
