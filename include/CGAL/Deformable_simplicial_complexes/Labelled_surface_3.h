// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_LABELLED_SURFACE_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_LABELLED_SURFACE_3_H

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

is a triangle soup that bounds a solid, together with the label of that solid. Soups need neither
be consistently oriented nor share points between facets: what is inside is decided by how often
the surface is crossed on the way in.

\tparam Point is a point type such as `Deformable_simplicial_complex_3::Point_3`.
*/
template <class Point> struct Labelled_surface_3
{
  std::vector<Point> points;                         ///< the corners of the triangles
  std::vector<std::array<std::size_t, 3>> triangles; ///< indices into `points`
  int label = 1;                                     ///< the label of the solid; 0 is the outside
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_LABELLED_SURFACE_3_H
