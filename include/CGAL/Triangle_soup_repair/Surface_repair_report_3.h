// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_SURFACE_REPAIR_REPORT_3_H
#define CGAL_TRIANGLE_SOUP_REPAIR_SURFACE_REPAIR_REPORT_3_H

#include <cstddef>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgTriangleSoupRepairRef

Report of `repair_surface_3()` and `wrap_surface_3()`. If `was_sound()` is true, the surface is
unchanged.
*/
struct Surface_repair_report_3
{
  /// points removed since they equal others or are in no triangle
  std::size_t merged_points = 0;
  std::size_t degenerate_triangles = 0; ///< removed triangles without area
  std::size_t repeated_triangles = 0;   ///< removed triangles with the same corners as others
  std::size_t stitched_points = 0;      ///< boundary points that were merged with near ones
  std::size_t split_edges = 0;          ///< edges that were split at vertices on them
  std::size_t filled_holes = 0;         ///< holes that were filled
  std::size_t crossing_pairs = 0;       ///< pairs of triangles that intersected
  /// self-intersecting or intersecting components that were united
  std::size_t united_parts = 0;
  /// removed triangles that bounded no solid, such as walls inside
  std::size_t removed_triangles = 0;
  bool is_wrapped = false; ///< whether the whole surface was replaced by an alpha wrap
  double alpha = 0;        ///< alpha of the wrap, in the unit of the coordinates
  double offset = 0;       ///< offset of the wrap, in the unit of the coordinates
  /// mean edge length of the input, in the unit of the coordinates
  double mean_edge = 0;
  /// largest distance of a sample of the input from the result; samples of removed components
  /// count, but triangles inside united components do not
  double distance_from_input = 0;
  double distance_to_input = 0; ///< largest distance of a sample of the result from the input

  /// Returns whether the input bounded a solid.
  bool was_sound() const {
    return merged_points + degenerate_triangles + repeated_triangles + stitched_points +
                   split_edges + filled_holes + crossing_pairs + united_parts + removed_triangles ==
               0 &&
           !is_wrapped;
  }

  /// Returns the Hausdorff distance between input and result, estimated with samples: the larger
  /// one of both distances.
  double distance() const {
    return distance_from_input > distance_to_input ? distance_from_input : distance_to_input;
  }
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_TRIANGLE_SOUP_REPAIR_SURFACE_REPAIR_REPORT_3_H
