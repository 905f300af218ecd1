// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BUILDING_PLANAR_FILLING_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BUILDING_PLANAR_FILLING_2_H

#include <CGAL/Deformable_simplicial_complexes/internal/building/Curve_soup_2.h>

#include <CGAL/Bbox_2.h>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Triangles that fill a box. The segments of the curves are edges of the triangles. The spacing of
// additional points follows the lengths of the nearest segments.
struct Planar_filling_2
{
  using Point = Planar_kernel::Point_2;

  struct Place
  {
    // a triangle that contains the point, on its boundary or inside
    std::optional<std::size_t> triangle;
    bool is_on_segment;
  };

  std::vector<Point> points; // the points of the soup, then additional points
  std::vector<std::array<std::size_t, 3>> triangles;
  std::function<Place(const Point&)> locate; // returns no triangle for a point outside the box
};

// Triangulates a box with curves in it. Throws `Invalid_surface_error` if segments cross or
// overlap. Complexity: O(n log n) if few bounding boxes of segments overlap.
#ifdef CGAL_DSC_EXTERN // see the component Compiled
Planar_filling_2 fill_planar_box(const Curve_soup_2& soup, const Bbox_2& box);
#else
inline Planar_filling_2 fill_planar_box(const Curve_soup_2& soup, const Bbox_2& box);
#endif

// Triangulates a box like `fill_planar_box()`, without a test for crossings. Curves may end on the
// box. There may be no curve.
// \pre Segments of the curves do not cross.
#ifdef CGAL_DSC_EXTERN
Planar_filling_2 fill_box_between(const Curve_soup_2& soup, const Bbox_2& box);
#else
inline Planar_filling_2 fill_box_between(const Curve_soup_2& soup, const Bbox_2& box);
#endif

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#ifndef CGAL_DSC_EXTERN
#include <CGAL/Deformable_simplicial_complexes/internal/building/Planar_filling_2_impl.h>
#endif

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BUILDING_PLANAR_FILLING_2_H
