// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_EDGE_SPLIT_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_EDGE_SPLIT_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>
#include <CGAL/Deformable_simplicial_complexes/Cavity.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to split an edge at a point. Each cell around the edge is divided into two, which keep its
label. The new vertex is on the sides of the domain that contain the edge. Linear in the number of
cells around the edge.

\param complex the complex; it is not changed
\param cell, i, j the edge between the finite vertices i and j of the cell
\param point position of the new vertex. If it is not on the edge, the interface changes
       accordingly.
\param cavity filled with the proposal if there is one; its last vertex is the new one
\return whether all new cells are positively oriented and `complex.keeps_quality()` holds
\pre if the edge is on the boundary of the domain, the point is on the edge, up to rounding
*/
template <class Complex>
bool propose_edge_split(const Complex& complex, typename Complex::Cell_handle cell, int i, int j,
                        const typename Complex::Point& point,
                        Deformable_simplicial_complexes::Cavity<Complex>& cavity) {
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  using Index = typename Deformable_simplicial_complexes::Cavity<Complex>::Index;
  const Vertex_handle a = cell->vertex(i), b = cell->vertex(j);
  cavity.begin(Proposal_kind::split);
  std::vector<Cell_handle> around;
  Complex::Space::cells_around_edge(complex.triangulation(), cell, i, j, around);
  bool is_on_boundary = false;
  for (Cell_handle c : around) {
    is_on_boundary = is_on_boundary || complex.is_infinite(c);
    cavity.remove(c);
  }
  const Index middle = cavity.add(point, is_on_boundary ? a->boundary_class() & b->boundary_class()
                                                        : Boundary_class::inside);
  for (std::size_t k = 0; k < cavity.removed().size(); ++k) {
    const auto parent = cavity.removed()[k];
    std::array<Index, Complex::corners> whole;
    for (int v = 0; v < Complex::corners; ++v)
      whole[v] = cavity.add(parent->vertex(v));
    std::array<Index, Complex::corners> half = whole;
    half[parent->index(a)] = middle;
    cavity.create(half, parent);
    half = whole;
    half[parent->index(b)] = middle;
    cavity.create(half, parent);
  }
  return cavity.is_admissible();
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to split an edge at the fraction `ratio` of the vector from i to j, in (0, 1). The
interface moves only by the rounding of the point. Otherwise the function is the same as the
overload above.
*/
template <class Complex>
bool propose_edge_split(const Complex& complex, typename Complex::Cell_handle cell, int i, int j,
                        double ratio, Deformable_simplicial_complexes::Cavity<Complex>& cavity) {
  const auto a = cell->vertex(i), b = cell->vertex(j);
  const auto point = complex.position(a) + ratio * complex.displacement(a, b);
  return propose_edge_split(complex, cell, i, j, point, cavity);
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_EDGE_SPLIT_H
