// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_INTERFACE_BENDS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_INTERFACE_BENDS_H

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

/*
How the interface of a snapshot bends at its vertices. In each dimension:

- `normals(snapshot, positions)`: unit normals, out of the larger label; 0 where facets cancel each
  other
- `on_features(snapshot, positions, angle)`: for each vertex, whether facets that meet there differ
  by more than an angle, in radians
*/
template <class Complex, int dimension = Complex::dimension> struct Interface_bends;

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_INTERFACE_BENDS_H
