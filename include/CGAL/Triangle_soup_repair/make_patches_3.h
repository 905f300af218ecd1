// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Triangle_soup_repair, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_MAKE_PATCHES_3_H
#define CGAL_TRIANGLE_SOUP_REPAIR_MAKE_PATCHES_3_H

#include <CGAL/license/Triangle_soup_repair.h>

#include <CGAL/Triangle_soup_repair/Labeled_patch_3.h>
#include <CGAL/Triangle_soup_repair/Labeled_surface_3.h>
#include <CGAL/Triangle_soup_repair/internal/repair/shared_walls_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgTriangleSoupRepairRef

The patches between the regions that closed surfaces bound, and the labels of these regions.
*/
template <class Point> struct Patches_of_surfaces_3
{
  std::vector<Labeled_patch_3<Point>> patches; ///< one for each pair of labels that share a wall
  /// labels of the regions of each surface; the first one is the label of the surface
  std::vector<std::vector<int>> labels;
};

/*!
\ingroup PkgTriangleSoupRepairRef

Makes patches from closed surfaces that share walls, such as the boundaries of several materials,
for `make_deformable_simplicial_complex_3()`. n log n in the number of triangles, times the number
of regions.

Surfaces may touch in any way: the triangulations of a wall in two surfaces may be different.
Surfaces may be nested; the innermost surface determines the label. Otherwise, surfaces must not
overlap. Walls between regions of the same label are ignored.

A single surface may have inner walls, too: triangles that occur twice, as between closed components
that touch, or edges of three triangles. Each bounded region of such a surface gets its own label.
The first region gets the label of the surface. The others get the next labels that no surface has,
in the order of their first triangles.

Triangles are split where they meet, with exact arithmetic; the intersection points are rounded.

\tparam Point a point type with `double` coordinates, such as that of `Labeled_surface_3`

\param surfaces the closed surfaces with their labels
\return the patches, and the labels of the regions
\throws Invalid_surface_error if coordinates are not finite, indices are wrong, a triangle has no
        area, or a surface is not closed, intersects itself, or overlaps another one
\throws Interrupted_error if the callback of a `Progress_scope` returns `false`
\pre Labels are small enough that the labels of the additional regions are values of type `int`.
*/
template <class Point>
Patches_of_surfaces_3<Point> make_patches_3(const std::vector<Labeled_surface_3<Point>>& surfaces) {
  std::set<int> taken = {0};
  for (const auto& surface : surfaces)
    taken.insert(surface.label);
  std::vector<internal::Cell_surface_3> cells;
  std::vector<int> labels; // labels of `cells`
  Patches_of_surfaces_3<Point> result;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    internal::Triangle_soup_3 soup;
    for (const Point& p : surfaces[s].points)
      soup.points.push_back(internal::coordinates(p));
    soup.triangles = surfaces[s].triangles;
    result.labels.emplace_back();
    for (internal::Triangle_soup_3& cell : internal::surfaces_of_cells(soup, s)) {
      int label = surfaces[s].label;
      if (!result.labels.back().empty())
        while (!taken.insert(label).second)
          ++label;
      cells.push_back({std::move(cell), s});
      labels.push_back(label);
      result.labels.back().push_back(label);
    }
  }

  const internal::Walled_regions_3 regions = internal::divide_by_walls(cells);
  const auto label_of = [&](std::size_t cell) {
    return cell == internal::Walled_regions_3::outside ? 0 : labels[cell];
  };
  // by the labels behind and in front of it
  std::map<std::array<int, 2>, internal::Triangle_soup_3> walls;
  for (std::size_t t = 0; t < regions.sides.size(); ++t) {
    std::array<int, 2> sides = {label_of(regions.sides[t].behind),
                                label_of(regions.sides[t].in_front)};
    auto triangle = regions.soup.triangles[t];
    if (sides[0] < sides[1]) {
      std::swap(sides[0], sides[1]);
      std::swap(triangle[1], triangle[2]);
    }
    if (sides[0] != sides[1])
      walls[sides].triangles.push_back(triangle);
  }
  for (auto& [sides, wall] : walls) {
    wall.points = regions.soup.points;
    const auto merged = internal::merge_points(wall);
    Labeled_patch_3<Point> patch;
    for (const auto& p : merged.points)
      patch.points.push_back(Point(p[0], p[1], p[2]));
    patch.triangles = merged.triangles;
    patch.label_behind = sides[0];
    patch.label_in_front = sides[1];
    result.patches.push_back(std::move(patch));
  }
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_TRIANGLE_SOUP_REPAIR_MAKE_PATCHES_3_H
