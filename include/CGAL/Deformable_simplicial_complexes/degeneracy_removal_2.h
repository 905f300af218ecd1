// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEGENERACY_REMOVAL_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEGENERACY_REMOVAL_2_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/edge_collapse.h>
#include <CGAL/Deformable_simplicial_complexes/edge_flip_2.h>
#include <CGAL/Deformable_simplicial_complexes/topology_of_relabeling.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to flip the longest edge of a cap, an edge of the interface, together with the interface:
both new triangles get the label of the other side, so that the tip of the cap, if it is on the
interface, takes the place of the edge.

\param complex is not changed.
\param cell, i the edge opposite to the vertex i of a finite triangle, the tip.
\param cavity filled with the proposal if there is one.
\return whether the edge is on the interface, the tip, too, the topology stays, both new triangles
        are positive, and the worse of them is better than the worse of the two. The interface moves
        by the cap.

Linear in the stars of the vertices. Section 3.1 of the paper.
*/
template <class Complex>
bool propose_cap_flip(const Complex& complex, typename Complex::Cell_handle cell, int i,
                      Deformable_simplicial_complexes::Cavity<Complex>& cavity) {
  const auto other = cell->neighbor(i);
  if (complex.is_infinite(other) || other->label() == cell->label() ||
      !cell->vertex(i)->is_interface() || !relabeling_keeps_topology(complex, cell, other->label()))
    return false;
  internal::plan_flip(cell, i, other, cavity);
  return cavity.quality_after() > cavity.quality_before() && cavity.is_positive();
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to remove a triangle with a small angle. The longest edge of a *cap*, a triangle with an
obtuse angle, is flipped, by `propose_cap_flip()` if it is on the interface; if that cannot be, and
of a *needle*, the shortest edge is collapsed.

\param complex is not changed.
\param cell a triangle.
\param cosine only triangles with an angle of larger cosine are considered. The paper takes 0.99 for
       minus the cosine of the angle of a cap, and an angle of 0.01 &pi; for needles.
\param minimum_quality no new triangle of a collapse may be worse.
\param cavity filled with the proposal if there is one.
\return whether the triangle is finite, has a small angle, and there is a proposal. The interface
        keeps its topology. It stays as it is, or moves by the triangles that are replaced.

As these. Section 3.1 of the paper.
*/
template <class Complex>
bool propose_degenerate_triangle_removal(const Complex& complex, typename Complex::Cell_handle cell,
                                         double cosine, double minimum_quality,
                                         Deformable_simplicial_complexes::Cavity<Complex>& cavity) {
  if (complex.is_infinite(cell))
    return false;
  std::array<double, 3> squared; // lengths of the edges opposite to the three vertices
  for (int i = 0; i < 3; ++i)
    squared[i] =
        complex.displacement(cell->vertex((i + 1) % 3), cell->vertex((i + 2) % 3)).squared_length();
  const int shortest = int(std::min_element(squared.begin(), squared.end()) - squared.begin()),
            longest = int(std::max_element(squared.begin(), squared.end()) - squared.begin());
  const auto cosine_at = [&](int i) {
    const double p = squared[(i + 1) % 3], q = squared[(i + 2) % 3];
    return (p + q - squared[i]) / (2 * std::sqrt(p * q));
  };
  if (!(cosine_at(shortest) > cosine))
    return false;
  return (cosine_at(longest) < 0 && (propose_edge_flip(complex, cell, longest, cavity) ||
                                     propose_cap_flip(complex, cell, longest, cavity))) ||
         internal::propose_collapse_either_way(complex, cell, (shortest + 1) % 3,
                                               (shortest + 2) % 3, minimum_quality, cavity);
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEGENERACY_REMOVAL_2_H
