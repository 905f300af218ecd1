// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_RELABELING_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_RELABELING_H

#include <CGAL/Deformable_simplicial_complexes/internal/geometry/Facet_normals.h>

#include <cmath>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Proposes another label for a nearly flat cell trapped between two parts of the interface
("tetrahedron relabeling", section 3.2.1 of the paper). By the first rule, the largest facet of the
cell lies on the interface, the opposite vertex lies on the interface or on the boundary of the
domain, and that vertex projects into the facet: the cell joins the phase behind the facet. By the
second one, for half the threshold, it joins the neighboring phase that decreases the area of the
interface most, if one does. The topology of the interface may change.

\param complex is not changed.
\param cell a finite cell.
\param threshold only cells of lower quality are considered; the paper takes 0.01.
\param label the proposed label.
\return whether there is a proposal; commit with `complex.relabel(cell, label)`.

Constant time.
*/
template <class Complex>
bool propose_relabeling(const Complex& complex, typename Complex::Cell_handle cell,
                        double threshold, typename Complex::Label& label) {
  if (!(cell->quality() < threshold))
    return false;
  const Deformable_simplicial_complexes::internal::Facet_normals<Complex> normals(complex, cell);
  const int largest = normals.largest();

  const auto opposite = cell->vertex(largest);
  if (complex.is_interface(std::make_pair(cell, largest)) &&
      (opposite->is_interface() || complex.is_boundary(opposite))) {
    // The projection lies in the facet iff the three other facets face the other way.
    bool is_inside = true;
    for (int i = 0; i < Complex::corners; ++i)
      is_inside = is_inside && (i == largest || normals[i] * normals[largest] <= 0);
    if (is_inside) {
      label = cell->neighbor(largest)->label();
      return true;
    }
  }

  if (!(cell->quality() < threshold / 2))
    return false;
  double best = 0;
  for (int candidate = 0; candidate < Complex::corners; ++candidate) {
    if (!complex.is_interface(std::make_pair(cell, candidate)))
      continue;
    double change = 0; // of the measure of the interface, up to a factor
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

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_RELABELING_H
