// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_EDGE_FLIP_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_EDGE_FLIP_2_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// Fills a cavity with the flip of the edge opposite to the vertex i of a triangle. The first new
// triangle gets the label of `heir`, the second one the label of the neighbor.
template <class Cell_handle, class Complex>
void plan_flip(Cell_handle cell, int i, Cell_handle heir, Cavity<Complex>& cavity) {
  const Cell_handle other = cell->neighbor(i);
  cavity.begin(Proposal_kind::flip);
  cavity.remove(cell);
  cavity.remove(other);
  // The cell, with its vertex c, is on the left of the edge from a to b.
  const auto a = cavity.add(cell->vertex((i + 1) % 3)), b = cavity.add(cell->vertex((i + 2) % 3)),
             c = cavity.add(cell->vertex(i)), d = cavity.add(other->vertex(other->index(cell)));
  cavity.create({c, a, d}, heir);
  cavity.create({c, d, b}, other);
}

} // namespace internal

template <class Complex>
bool propose_edge_flip(const Complex& complex, typename Complex::Cell_handle cell, int i,
                       Deformable_simplicial_complexes::Cavity<Complex>& cavity) {
  const auto other = cell->neighbor(i);
  if (complex.is_infinite(other) || other->subdomain_index() != cell->subdomain_index())
    return false;
  internal::plan_flip(cell, i, cell, cavity);
  return cavity.quality_after() > cavity.quality_before() && cavity.is_positive();
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_EDGE_FLIP_2_H
