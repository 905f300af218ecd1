// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Complex_construction, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_COMPLEX_CONSTRUCTION_FILL_TORUS_H
#define CGAL_COMPLEX_CONSTRUCTION_FILL_TORUS_H

#include <CGAL/license/Complex_construction.h>

#include <CGAL/Complex_construction/fill_grid.h>
#include <CGAL/Complex_construction/internal/building/torus_grid.h>
#include <CGAL/Deformable_simplicial_complexes/Torus_domain.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgComplexConstructionRef

Makes a complex on a flat torus from a function of labels. Linear in the number of cells.

\tparam Complex a complex with the domain `Torus_domain`
\param domain the torus
\param edge approximate edge length, positive
\param label_at `label_at(p)` returns the label at an `Approximate_point`; or
       `label_at(points)` returns the labels at a vector of such points
\param np named parameters or `Deformation_options` of `deform_interface()`, for `fit_interface()`
\throws Error if `edge` is out of range
*/
template <class Complex, class LabelAt, class NamedParameters>
Complex fill_torus(const Torus_domain<Complex::dimension>& domain, double edge,
                   const LabelAt& label_at, const NamedParameters& np) {
  return internal::fill_grid(Complex(domain), internal::torus_grid(domain.periods(), edge),
                             label_at, np);
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_COMPLEX_CONSTRUCTION_FILL_TORUS_H
