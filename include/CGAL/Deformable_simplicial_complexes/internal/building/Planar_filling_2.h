// Copyright (c) 2026 The deformable simplicial complex authors
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

// Triangles that fill a box, with the segments of curves among their edges, and points as dense as
// those of the curves near them.
struct Planar_filling_2
{
  using Point = Planar_kernel::Point_2;

  struct Place
  {
    std::optional<std::size_t> triangle; // one with the point in it or on its boundary
    bool is_on_segment;
  };

  std::vector<Point> points; // of the soup, then others
  std::vector<std::array<std::size_t, 3>> triangles;
  std::function<Place(const Point&)> locate; // no triangle outside the box
};

// Throws `Invalid_surface_error` where segments cross or overlap others. n log n, if few boxes
// around them overlap.
#ifdef CGAL_DSC_EXTERN // see the component Compiled
Planar_filling_2 fill_planar_box(const Curve_soup_2& soup, const Bbox_2& box);
#else
inline Planar_filling_2 fill_planar_box(const Curve_soup_2& soup, const Bbox_2& box);
#endif

// The same for curves that are known not to cross, which may end on the box; or for none.
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
