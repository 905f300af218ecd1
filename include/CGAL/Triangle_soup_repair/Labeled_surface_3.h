// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_LABELED_SURFACE_3_H
#define CGAL_TRIANGLE_SOUP_REPAIR_LABELED_SURFACE_3_H

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgTriangleSoupRepairRef

A triangle soup that separates two labels, such as the wall between two materials, and the labels on
its two sides. All triangles are oriented consistently.

\tparam Point a point type, such as `Deformable_simplicial_complex_3::Point_3`
*/
template <class Point> struct Labeled_patch_3
{
  std::vector<Point> points;                         ///< corners of the triangles
  std::vector<std::array<std::size_t, 3>> triangles; ///< indices into `points`
  /// label on the side from which corners are seen clockwise
  int label_behind = 1;
  int label_in_front = 0; ///< label on the side from which corners are seen counterclockwise
};

/*!
\ingroup PkgTriangleSoupRepairRef

A triangle soup that bounds a solid, and the label of the solid. The triangles need not be
consistently oriented, and need not share points. A point is inside if a path from the outside
crosses the surface an odd number of times.

\tparam Point a point type, such as `Deformable_simplicial_complex_3::Point_3`
*/
template <class Point> struct Labeled_surface_3
{
  std::vector<Point> points;                         ///< corners of the triangles
  std::vector<std::array<std::size_t, 3>> triangles; ///< indices into `points`
  int label = 1;                                     ///< label of the solid; 0 is the outside
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_TRIANGLE_SOUP_REPAIR_LABELED_SURFACE_3_H
