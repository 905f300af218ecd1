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

#include <CGAL/Deformable_simplicial_complexes/Interface_energy.h>
#include <CGAL/Deformable_simplicial_complexes/internal/geometry/Facet_normals.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {
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

// Returns whether the phase of a cell wets the interface between the phase behind a facet and one
// at the opposite vertex: whether two interfaces with the phase have less energy than one without
// it.
template <class Complex>
bool wets(const Complex& complex, typename Complex::Cell_handle cell, int facet,
          const Interface_energy& energy) {
  if (!energy.has_tensions())
    return false;
  const auto own = cell->label(), behind = cell->neighbor(facet)->label();
  std::vector<typename Complex::Cell_handle> star;
  complex.star(cell->vertex(facet), star);
  return std::any_of(star.begin(), star.end(), [&](auto c) {
    const auto other = c->label();
    return !complex.is_infinite(c) && other != own && other != behind &&
           energy.tension(other, behind) > energy.tension(other, own) + energy.tension(own, behind);
  });
}

} // namespace internal

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes another label for a nearly flat cell trapped between two parts of the interface
("tetrahedron relabeling", section 3.2.1 of the paper). The topology of the interface may change.
Linear in the star of a vertex.

First rule: the largest facet of the cell lies on the interface, and the opposite vertex projects
into the facet. This vertex is on the interface or on the boundary of the domain. The cell then
joins the phase behind the facet. The facet may be smaller than the largest one by 2 % (in 2D, by 1
%). The projection may be outside the facet by a hundredth of its height.

The cell keeps its label if its phase wets the interface between the phase behind the facet and a
phase at the opposite vertex: a thin layer that wets an interface stays.

Second rule, for half the threshold: the cell joins the neighboring phase for which the energy of
the interface decreases most, if there is one.

\param complex the complex; it is not changed
\param cell a finite cell
\param threshold only cells of lower quality are considered; the paper uses 0.01
\param label the proposed label
\param energy the energy of the interface; energy densities have no effect. The default is the
       measure.
\return whether there is a proposal; commit it with `complex.relabel(cell, label)`
\throws Error if a tension is out of its range
*/
template <class Complex>
bool propose_relabeling(const Complex& complex, typename Complex::Cell_handle cell,
                        double threshold, typename Complex::Label& label,
                        const Interface_energy& energy = {}) {
  if (!(cell->quality() < threshold))
    return false;
  const internal::Facet_normals<Complex> normals(complex, cell);
  const auto energy_as = [&](typename Complex::Label other) { // up to a constant factor
    double result = 0;
    for (int i = 0; i < Complex::corners; ++i)
      if (!complex.is_infinite(cell->neighbor(i)) && cell->neighbor(i)->label() != other)
        result += energy.tension(cell->neighbor(i)->label(), other) *
                  std::sqrt(normals[i].squared_length());
    return result;
  };
  if (const int facet = internal::contact_facet(complex, cell, normals); facet >= 0) {
    label = cell->neighbor(facet)->label();
    return !internal::wets(complex, cell, facet, energy);
  }

  if (!(cell->quality() < threshold / 2))
    return false;
  double best = energy_as(cell->label());
  bool is_found = false;
  for (int candidate = 0; candidate < Complex::corners; ++candidate) {
    if (!complex.is_interface(std::make_pair(cell, candidate)))
      continue;
    const auto other = cell->neighbor(candidate)->label();
    if (const double changed = energy_as(other); changed < best) {
      best = changed;
      label = other;
      is_found = true;
    }
  }
  return is_found;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_RELABELING_H
