// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TRAVERSAL_LOCAL_EDGE_LENGTH_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TRAVERSAL_LOCAL_EDGE_LENGTH_H

#include <CGAL/Deformable_simplicial_complexes/internal/traversal/star_union.h>
#include <CGAL/Mesh_support/Error.h>

namespace CGAL::Deformable_simplicial_complexes {

// Throws an exception if a complex has an interface, but no mean edge of the initial interface to
// be the unit of lengths. This happens if the complex was built without an interface. The time is
// constant if there is such a mean edge.
//
// \throws Error if there are vertices on the interface and `complex.mean_interface_edge()` is 0
template <class Complex> void require_interface_edge(const Complex& complex) {
  if (!(complex.mean_interface_edge() > 0) && !complex.interface_vertices().empty())
    throw Error("the complex was built without an interface and has no unit of length: call "
                "measure_interface_edges()");
}

namespace internal {

// Returns the local edge length, the unit of length thresholds at a vertex. It is the spacing of
// the vertex, which follows the target edge lengths of the user but not the stretching or shrinking
// by motion. So details that shrink below the target edge length are removed. Without a spacing, it
// is the length of the interface edges at the vertex.
template <class Complex>
double local_edge_length(const Complex& complex, typename Complex::Vertex_handle v) {
  return v->spacing() > 0 ? v->spacing() : complex.interface_edge_length(v);
}

// Returns the mean local edge length of the interface vertices of the cells; 0 without any.
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
} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TRAVERSAL_LOCAL_EDGE_LENGTH_H
