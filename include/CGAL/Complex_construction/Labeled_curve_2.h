// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_LABELED_CURVE_2_H
#define CGAL_COMPLEX_CONSTRUCTION_LABELED_CURVE_2_H

#include <CGAL/Polygon_with_holes_2.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgComplexConstructionRef

A set of segments that divide the plane, and seeds: points in some of the regions between the
segments, with the labels of these regions. Bounded regions without a seed get the label
`enclosed_label`. If the unbounded region has no seed, it gets label 0. Any number of segments may
meet in a point, as in a foam or in files of the format of Triangle (`.poly`).

\tparam Point a point type, such as `Deformable_simplicial_complex_2::Point_2`
*/
template <class Point> struct Seeded_segments_2
{
  std::vector<Point> points;                        ///< ends of the segments
  std::vector<std::array<std::size_t, 2>> segments; ///< indices into `points`
  std::vector<std::pair<Point, int>> seeds;         ///< points in regions, with their labels
  int enclosed_label = 0;                           ///< label of bounded regions without a seed
};

/*!
\ingroup PkgComplexConstructionRef

A set of segments that bound a region of the plane, and the label of the region. The class
`Labeled_surface_3` is the counterpart in space. Segments may have any order and any direction. A
point is inside if a path from the outside crosses an odd number of segments.

\tparam Point a point type, such as `Deformable_simplicial_complex_2::Point_2`
*/
template <class Point> struct Labeled_curve_2
{
  std::vector<Point> points;                        ///< ends of the segments
  std::vector<std::array<std::size_t, 2>> segments; ///< indices into `points`
  int label = 1;                                    ///< label of the region; 0 is the outside

  /// Adds a closed polyline. The last point is connected with the first one, or equal to it.
  template <class Points> void add_polyline(const Points& polyline) {
    const std::size_t first = points.size();
    points.insert(points.end(), polyline.begin(), polyline.end());
    if (points.size() > first + 1 && points.back() == points[first])
      points.pop_back();
    for (std::size_t i = first; i < points.size(); ++i)
      segments.push_back({i, i + 1 < points.size() ? i + 1 : first});
  }

  /// Adds the boundaries of a polygon with holes. \pre the polygon is bounded
  template <class Kernel, class Container>
  void add_polygon(const Polygon_with_holes_2<Kernel, Container>& polygon) {
    add_polyline(polygon.outer_boundary());
    for (const auto& hole : polygon.holes())
      add_polyline(hole);
  }
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_COMPLEX_CONSTRUCTION_LABELED_CURVE_2_H
