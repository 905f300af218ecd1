// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_EDGE_SPLIT_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_EDGE_SPLIT_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>

namespace CGAL::Deformable_simplicial_complexes {

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

template <class Complex>
bool propose_edge_split(const Complex& complex, typename Complex::Cell_handle cell, int i, int j,
                        double ratio, Deformable_simplicial_complexes::Cavity<Complex>& cavity) {
  const auto a = cell->vertex(i), b = cell->vertex(j);
  const auto point = complex.position(a) + ratio * complex.displacement(a, b);
  return propose_edge_split(complex, cell, i, j, point, cavity);
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_EDGE_SPLIT_H
