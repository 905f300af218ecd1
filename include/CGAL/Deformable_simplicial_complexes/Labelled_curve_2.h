// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_LABELLED_CURVE_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_LABELLED_CURVE_2_H

#include <CGAL/Polygon_with_holes_2.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

is a set of segments that bound a region of the plane, together with the label of that region: the
twin of `Labelled_surface_3`. Segments may be in any order and have any direction: what is inside is
decided by how often they are crossed on the way in.

\tparam Point is a point type such as `Deformable_simplicial_complex_2::Point_2`.
*/
template <class Point> struct Labelled_curve_2
{
  std::vector<Point> points;                        ///< the ends of the segments
  std::vector<std::array<std::size_t, 2>> segments; ///< indices into `points`
  int label = 1;                                    ///< the label of the region; 0 is the outside

  /// Adds a closed polyline, whose last point is joined to the first, or is equal to it.
  template <class Points> void add_polyline(const Points& polyline) {
    const std::size_t first = points.size();
    points.insert(points.end(), polyline.begin(), polyline.end());
    if (points.size() > first + 1 && points.back() == points[first])
      points.pop_back();
    for (std::size_t i = first; i < points.size(); ++i)
      segments.push_back({i, i + 1 < points.size() ? i + 1 : first});
  }

  /// Adds the boundaries of a polygon with holes. \pre it is bounded
  template <class Kernel, class Container>
  void add_polygon(const Polygon_with_holes_2<Kernel, Container>& polygon) {
    add_polyline(polygon.outer_boundary());
    for (const auto& hole : polygon.holes())
      add_polyline(hole);
  }
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_LABELLED_CURVE_2_H
