// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_SURFACE_REPAIR_REPORT_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_SURFACE_REPAIR_REPORT_3_H

#include <cstddef>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

What `repair_surface_3()` or `wrap_surface_3()` did to a surface. If `was_sound()` is true, the
surface is unchanged.
*/
struct Surface_repair_report_3
{
  std::size_t merged_points = 0;        ///< points that equal others or are in no triangle
  std::size_t degenerate_triangles = 0; ///< triangles without area that were removed
  std::size_t repeated_triangles =
      0;                           ///< triangles removed with or beside others of the same corners
  std::size_t stitched_points = 0; ///< points of borders that were near others and became one
  std::size_t split_edges = 0;     ///< edges that were split at vertices that lie on them
  std::size_t filled_holes = 0;    ///< holes that were closed
  std::size_t crossing_pairs = 0;  ///< pairs of triangles that crossed
  std::size_t united_parts = 0;    ///< parts that crossed others or themselves and were united
  std::size_t removed_triangles = 0; ///< triangles that bounded nothing, such as walls inside
  bool is_wrapped = false;           ///< whether all was replaced by an alpha wrap
  double alpha = 0;                  ///< of the wrap, in the unit of the coordinates
  double offset = 0;                 ///< of the wrap, in the unit of the coordinates
  double mean_edge = 0;              ///< of the triangles of the input, in that unit
  double distance_from_input =
      0; ///< from the farthest sample of the input, also of parts that were removed, to the result;
         ///< triangles inside united parts do not count
  double distance_to_input = 0; ///< from the farthest sample of the result to the input

  /// returns whether the surface bounded a solid before.
  bool was_sound() const {
    return merged_points + degenerate_triangles + repeated_triangles + stitched_points +
                   split_edges + filled_holes + crossing_pairs + united_parts + removed_triangles ==
               0 &&
           !is_wrapped;
  }

  /// returns the Hausdorff distance to the input, as far as samples tell: the larger one of both.
  double distance() const {
    return distance_from_input > distance_to_input ? distance_from_input : distance_to_input;
  }
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_SURFACE_REPAIR_REPORT_3_H
