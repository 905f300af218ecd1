// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_KEEPS_VOLUMES_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_KEEPS_VOLUMES_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/internal/balance/Interface_tolerance.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Returns whether a proposal moves only a small volume from one label to another, as the operations of
`deform_interface()` do. The bound is three percent of the volume that each label has in the cells
around the operation. It is smaller where a label is thin relative to the edges of the interface.
Linear in the number of these cells.

\param complex the complex
\param cavity a proposal that collapses an edge or, in space, flips an edge of the interface. For
       other proposals, the function returns `true` without a test.
*/
template <class Complex> bool keeps_volumes(const Complex& complex, const Cavity<Complex>& cavity) {
  return internal::Interface_tolerance<Complex>(complex).allows(cavity);
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_KEEPS_VOLUMES_H
