// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_RELABELING_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_RELABELING_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/internal/geometry/Facet_normals.h>

#include <cmath>
#include <utility>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Returns the largest facet of a cell if it lies on the interface and the opposite vertex touches
// it; -1 otherwise. The opposite vertex is on the interface or on the boundary of the domain.
// Between two parts of the interface with the same triangulation, vertices project to vertices, and
// two facets are equally large. Tolerances prevent rounding from deciding these cases.
template <class Complex>
int contact_facet(const Complex& complex, typename Complex::Cell_handle cell,
                  const Facet_normals<Complex>& normals) {
  static constexpr double outside = .01; // tolerance of a barycentric coordinate of the projection
  // as a fraction of the largest facet
  static constexpr double least = 1 - (Complex::dimension - 1) * outside;
  int result = -1;
  double largest = least * least * normals[normals.largest()].squared_length();
  for (int i = 0; i < Complex::corners; ++i) {
    const double size = normals[i].squared_length();
    bool touches = size > largest && complex.is_interface(std::make_pair(cell, i)) &&
                   (cell->vertex(i)->is_interface() || complex.is_boundary(cell->vertex(i)));
    for (int k = 0; k < Complex::corners && touches; ++k)
      touches = k == i || normals.coordinate_of_projection(i, k) >= -outside;
    if (touches) {
      result = i;
      largest = size;
    }
  }
  return result;
}

} // namespace internal

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes another label for a nearly flat cell trapped between two parts of the interface
("tetrahedron relabeling", section 3.2.1 of the paper). The topology of the interface may change.
Constant time.

First rule: the largest facet of the cell lies on the interface, and the opposite vertex projects
into the facet. This vertex is on the interface or on the boundary of the domain. The cell then
joins the phase behind the facet. The facet may be smaller than the largest one by 2 % (in 2D, by 1
%). The projection may be outside the facet by a hundredth of its height.

Second rule, for half the threshold: the cell joins the neighboring phase for which the measure of
the interface decreases most, if there is one.

\param complex the complex; it is not changed
\param cell a finite cell
\param threshold only cells of lower quality are considered; the paper uses 0.01
\param label the proposed label
\return whether there is a proposal; commit it with `complex.relabel(cell, label)`
*/
template <class Complex>
bool propose_relabeling(const Complex& complex, typename Complex::Cell_handle cell,
                        double threshold, typename Complex::Label& label) {
  if (!(cell->quality() < threshold))
    return false;
  const internal::Facet_normals<Complex> normals(complex, cell);
  if (const int facet = internal::contact_facet(complex, cell, normals); facet >= 0) {
    label = cell->neighbor(facet)->label();
    return true;
  }

  if (!(cell->quality() < threshold / 2))
    return false;
  double best = 0;
  for (int candidate = 0; candidate < Complex::corners; ++candidate) {
    if (!complex.is_interface(std::make_pair(cell, candidate)))
      continue;
    double change = 0; // of the measure of the interface, up to a constant factor
    for (int i = 0; i < Complex::corners; ++i)
      if (!complex.is_infinite(cell->neighbor(i))) {
        const auto other = cell->neighbor(i)->label();
        const double area = std::sqrt(normals[i].squared_length());
        change += other == cell->label() ? area : 0;
        change -= other == cell->neighbor(candidate)->label() ? area : 0;
      }
    if (change < best) {
      best = change;
      label = cell->neighbor(candidate)->label();
    }
  }
  return best < 0;
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_RELABELING_H
