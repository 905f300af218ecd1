// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_EDGE_SPLIT_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_EDGE_SPLIT_3_H

#include <CGAL/Deformable_simplicial_complex_3/Boundary_class.h>
#include <CGAL/Deformable_simplicial_complex_3/Cavity_3.h>

#include <array>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Proposes to split an edge at a point: each cell around it becomes two. Labels and boundary classes
are those of before, so that the interface changes by the rounding of the point only.

\param complex is not changed.
\param cell, i, j the edge between the finite vertices i and j of the cell.
\param ratio where to split, in (0, 1) from i to j.
\param cavity filled with the proposal if there is one. Its last vertex is the new one.
\return whether all new tetrahedra are positive.

Linear in the number of cells around the edge.
*/
template <class Complex>
bool propose_edge_split(const Complex& complex, typename Complex::Cell_handle cell, int i, int j,
                        double ratio, Cavity_3<Complex>& cavity) {
  using Vertex_handle = typename Complex::Vertex_handle;
  using Index = typename Cavity_3<Complex>::Index;
  const Vertex_handle a = cell->vertex(i), b = cell->vertex(j);
  cavity.clear();
  auto c = complex.triangulation().tds().incident_cells(cell, i, j), done = c;
  bool is_on_boundary = false;
  do {
    is_on_boundary = is_on_boundary || complex.is_infinite(typename Complex::Cell_handle(c));
    cavity.remove(typename Complex::Cell_handle(c));
  } while (++c != done);

  const auto p = complex.position(a), q = complex.position(b);
  const Index middle = cavity.add(
      complex.geom_traits().construct_exact_point_3_object()(p + ratio * (q - p)),
      is_on_boundary ? a->boundary_class() & b->boundary_class() : Boundary_class::inside);
  for (std::size_t k = 0; k < cavity.removed().size(); ++k) {
    const auto parent = cavity.removed()[k];
    std::array<Index, 4> whole;
    for (int v = 0; v < 4; ++v)
      whole[v] = cavity.add(parent->vertex(v));
    std::array<Index, 4> half = whole;
    half[parent->index(a)] = middle;
    cavity.create(half, parent);
    half = whole;
    half[parent->index(b)] = middle;
    cavity.create(half, parent);
  }
  return cavity.is_positive();
}

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_EDGE_SPLIT_3_H
