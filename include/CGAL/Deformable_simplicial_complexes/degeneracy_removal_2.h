// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEGENERACY_REMOVAL_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEGENERACY_REMOVAL_2_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/edge_collapse.h>
#include <CGAL/Deformable_simplicial_complexes/edge_flip_2.h>
#include <CGAL/Deformable_simplicial_complexes/topology_of_relabeling.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to flip the longest edge of a cap if the edge is on the interface. The interface is
flipped, too: both new triangles get the label of the other side of the edge. The two edges at the
tip of the cap, which must be on the interface, take the place of the flipped edge. Linear in the
stars of the vertices. Section 3.1 of the paper.

\param complex the complex; it is not changed
\param cell, i the edge opposite to the vertex i, the tip, of a finite triangle
\param cavity filled with the proposal if there is one
\return whether the proposal is valid: the edge and the tip are on the interface, and the topology
        stays. Both new triangles are positively oriented, and the worst quality rises. The
        interface moves by the area of the cap.
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

Proposes to remove a triangle with a small angle. Of a *cap*, a triangle with an obtuse angle, the
longest edge is flipped, with `propose_cap_flip()` if it is on the interface. If this is not
possible, or if the triangle is a *needle*, the shortest edge is collapsed. Section 3.1 of the
paper. The complexity is that of these functions.

\param complex the complex; it is not changed
\param cell a triangle
\param cosine only triangles with an angle of larger cosine are considered. The paper uses 0.99 for
       minus the cosine of the obtuse angle of a cap, and an angle of 0.01 &pi; for needles.
\param minimum_quality lower bound of the quality of the new triangles of a collapse
\param cavity filled with the proposal if there is one
\return whether the triangle is finite, has a small angle, and there is a proposal. The topology of
        the interface stays. The interface is unchanged, or moves by the triangles that are
        replaced.
*/
template <class Complex>
bool propose_degenerate_triangle_removal(const Complex& complex, typename Complex::Cell_handle cell,
                                         double cosine, double minimum_quality,
                                         Deformable_simplicial_complexes::Cavity<Complex>& cavity) {
  if (complex.is_infinite(cell))
    return false;
  std::array<double, 3> squared; // of the lengths of the edges opposite to the three vertices
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

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEGENERACY_REMOVAL_2_H
