// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_NEIGHBOR_EXCHANGE_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_NEIGHBOR_EXCHANGE_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <array>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef
Exchange of neighbors in 2D, called a T1 event in foams. Two phases lose the wall between them, and
the two phases at its ends become neighbors.
\tparam Complex an instance of `Deformable_simplicial_complex_2`
*/
template <class Complex> struct Neighbor_exchange
{
  std::array<typename Complex::Label, 2> parted; ///< labels on both sides of the old wall
  /// labels on both sides of the new wall; there is none if they are equal, for example where a
  /// phase reaches a side of the domain
  std::array<typename Complex::Label, 2> joined;
  typename Complex::Approximate_point where; ///< midpoint of the old wall
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_NEIGHBOR_EXCHANGE_H
