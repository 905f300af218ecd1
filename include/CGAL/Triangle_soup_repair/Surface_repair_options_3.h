// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_SURFACE_REPAIR_OPTIONS_3_H
#define CGAL_TRIANGLE_SOUP_REPAIR_SURFACE_REPAIR_OPTIONS_3_H

#include <CGAL/Mesh_support/Error.h>

#include <cmath>
#include <limits>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgTriangleSoupRepairRef

Options of `repair_surface_3()` and `wrap_surface_3()`.
*/
struct Surface_repair_options_3
{
  /// Vertices at a smaller distance are merged, even if the surface bounds a solid; in mean edge
  /// lengths of the surface, at least 0. Shorter edges vanish. Tetrahedralizers may fail where
  /// vertices nearly coincide.
  double merge_distance = 0;

  /// Length of the longest border of holes that are filled, at least 0. The unit is the diagonal of
  /// the bounding box of the connected component with the hole. Borders of planar cuts are up to
  /// 1.6 diagonals long, borders of flat sheets at least 2.
  double largest_hole = 1.6;

  /// Length of the longest border of holes that are filled, in the unit of the coordinates, at
  /// least 0. A hole is filled if its border exceeds neither bound.
  double longest_border = std::numeric_limits<double>::infinity();

  /// The parameter alpha of CGAL's alpha wrap, in mean edge lengths of the surface, at least 0; 0
  /// for no wrap. A ball of this radius does not pass smaller holes. At least a thousandth of the
  /// diagonal of the bounding box is used. A larger alpha closes larger gaps; a smaller one gives
  /// many more triangles.
  double wrap_alpha = 1;

  /// Distance of the wrap from the surface, in mean edge lengths, positive.
  double wrap_offset = .1;

  /// Throws an exception unless all values are in their ranges.
  /// \throws Error if a value is out of its range
  void check() const {
    if (!(merge_distance >= 0 && std::isfinite(merge_distance)))
      throw Error("the merge distance is negative or not finite: use 0 or more");
    if (!(largest_hole >= 0 && longest_border >= 0 && wrap_alpha >= 0 && std::isfinite(wrap_alpha)))
      throw Error("the largest hole, the longest border or the alpha of the wrap is out of range: "
                  "use 0 or more");
    if (!(wrap_offset > 0 && std::isfinite(wrap_offset)))
      throw Error("the offset of the wrap is not positive and finite: use more than 0");
  }
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_TRIANGLE_SOUP_REPAIR_SURFACE_REPAIR_OPTIONS_3_H
