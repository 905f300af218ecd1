// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_EDGE_SPLIT_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_EDGE_SPLIT_H

#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>
#include <CGAL/Deformable_simplicial_complexes/Cavity.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to split an edge at a point: each cell around it becomes two. Labels and boundary classes
are those of before.

\param complex is not changed.
\param cell, i, j the edge between the finite vertices i and j of the cell.
\param point where the new vertex is to be. If that is not on the edge, the interface changes
       accordingly. \pre it is on the edge, up to rounding, if that is on the boundary of the domain
\param cavity filled with the proposal if there is one. Its last vertex is the new one.
\return whether all new cells are positive and `complex.keeps_quality()`.

Linear in the number of cells around the edge.
*/
template <class Complex>
bool propose_edge_split(const Complex& complex, typename Complex::Cell_handle cell, int i, int j,
                        const typename Complex::Approximate_point& point,
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
  const Index middle =
      cavity.add(complex.exact(point), is_on_boundary ? a->boundary_class() & b->boundary_class()
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

The same, with the point given by the part of the way from i to j, in (0, 1): the interface changes
by the rounding of the point only.
*/
template <class Complex>
bool propose_edge_split(const Complex& complex, typename Complex::Cell_handle cell, int i, int j,
                        double ratio, Deformable_simplicial_complexes::Cavity<Complex>& cavity) {
  const auto a = cell->vertex(i), b = cell->vertex(j);
  const auto point = complex.position(a) + ratio * complex.displacement(a, b);
  return propose_edge_split(complex, cell, i, j, point, cavity);
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_EDGE_SPLIT_H
