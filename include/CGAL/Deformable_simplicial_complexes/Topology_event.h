// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_TOPOLOGY_EVENT_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_TOPOLOGY_EVENT_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Component_event.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef
A change of connected components of a label in a pass of a deformation, and its place.
\tparam Complex a deformable simplicial complex
*/
template <class Complex> struct Topology_event : public Component_event
{
  typename Complex::Approximate_point where; ///< place of one of the cells that changed their label
  unsigned pass;                             ///< pass of the deformation; the first one is 1
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_TOPOLOGY_EVENT_H
