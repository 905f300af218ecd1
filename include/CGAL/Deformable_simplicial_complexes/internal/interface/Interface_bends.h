// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_INTERFACE_BENDS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_INTERFACE_BENDS_H

#include <CGAL/Deformable_simplicial_complexes/internal/interface/Interface_bends_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/interface/Interface_bends_3.h>

#include <type_traits>

namespace CGAL::Deformable_simplicial_complexes::internal {

/*
The bending of the interface of a snapshot at its vertices. In each dimension:

- `normals(snapshot, positions)`: the unit normals, out of the larger label; 0 where the facet
  normals cancel each other
- `on_features(snapshot, positions, angle)`: for each vertex, whether the normals of two incident
  facets differ by more than `angle`, in radians
*/
template <class Complex>
using Interface_bends = std::conditional_t<Complex::dimension == 2, Interface_bends_2<Complex>,
                                           Interface_bends_3<Complex>>;

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_INTERFACE_BENDS_H
