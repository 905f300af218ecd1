// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Triangle_soup_repair, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_MAKE_PATCHES_3_H
#define CGAL_TRIANGLE_SOUP_REPAIR_MAKE_PATCHES_3_H

#include <CGAL/license/Triangle_soup_repair.h>

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Triangle_soup_repair/Invalid_surface_error.h>
#include <CGAL/Triangle_soup_repair/Labeled_surface_3.h>
#include <CGAL/Triangle_soup_repair/internal/checks/check_surfaces_3.h>
#include <CGAL/Triangle_soup_repair/internal/checks/refuse_surface.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Soup_regions_3.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Triangle_soup_3.h>
#include <CGAL/Triangle_soup_repair/internal/soups/split_at_crossings_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// A closed surface, and the input surface it belongs to.
struct Cell_surface_3
{
  Triangle_soup_3 soup;
  std::size_t surface; // index of the input surface
};

// Returns the triangles without repetitions: the first of several triangles with the same corners.
// `index[t]` becomes the new index of triangle t.
// \pre equal points are merged
inline std::vector<Triangle_indices>
distinct_triangles(const std::vector<Triangle_indices>& triangles,
                   std::vector<std::size_t>& index) {
  std::map<Triangle_indices, std::size_t> known;
  std::vector<Triangle_indices> result;
  for (const Triangle_indices& t : triangles) {
    Triangle_indices corners = t;
    std::sort(corners.begin(), corners.end());
    const auto [place, is_new] = known.emplace(corners, result.size());
    if (is_new)
      result.push_back(t);
    index.push_back(place->second);
  }
  return result;
}

// Returns the surfaces of the regions that a surface with walls encloses. Walls are triangles that
// occur several times, or that share an edge with at least two other triangles. A surface without
// walls is returned unchanged.
inline std::vector<Triangle_soup_3> surfaces_of_cells(const Triangle_soup_3& input,
                                                      std::size_t surface) {
  check_numbers(input, surface);
  const Merged_soup_3 merged = merge_points(input);
  check_areas(merged, surface);
  Triangle_soup_3 soup = {merged.points, {}};
  std::vector<std::size_t> index;
  soup.triangles = distinct_triangles(merged.triangles, index);
  bool has_walls = soup.triangles.size() < merged.triangles.size();
  const auto sides = sorted_sides(soup.triangles);
  for (auto side = sides.cbegin(); side != sides.cend();) {
    const auto end = end_of_edge(side, sides.cend());
    if (end - side == 1)
      check_closedness(merged, surface);
    has_walls |= (end - side) % 2 == 1;
    side = end;
  }
  if (!has_walls)
    return {input};
  if (const auto pairs = crossing_triangles(soup); !pairs.empty())
    refuse_surface(Invalid_surface_error::Reason::self_intersection, surface,
                   {pairs.front().first, pairs.front().second});
  const Soup_regions_3 regions(soup);
  std::vector<Triangle_soup_3> result(regions.size(), {soup.points, {}});
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    if (regions.in_front_of(t) != regions.behind(t))
      for (std::size_t r : {regions.in_front_of(t), regions.behind(t)})
        result[r].triangles.push_back(soup.triangles[t]);
  result.erase(result.begin() + Soup_regions_3::unbounded);
  if (result.size() < 2) // no wall divides a region: triangles are repeated by mistake
    return {input};
  for (Triangle_soup_3& cell : result)
    cell = merge_points(cell);
  return result;
}

// The regions of space that closed surfaces with common walls enclose.
struct Walled_regions_3
{
  struct Sides
  {
    std::size_t behind, in_front; // cell on each side of a triangle, or `outside`
  };

  static constexpr std::size_t outside = std::size_t(-1);

  Triangle_soup_3 soup;     // triangles meet in common vertices and edges only
  std::vector<Sides> sides; // sides of each triangle
};

// Returns the innermost of the cells that enclose each region. Throws Invalid_surface_error if two
// cells enclose the same regions, or overlap and neither contains the other.
inline std::vector<std::size_t> innermost_cells(const std::vector<std::vector<char>>& enclosed,
                                                const std::vector<Cell_surface_3>& cells,
                                                std::size_t number_of_regions) {
  std::vector<std::size_t> order(cells.size()), sizes;
  std::iota(order.begin(), order.end(), std::size_t(0));
  for (const std::vector<char>& regions : enclosed)
    sizes.push_back(std::size_t(std::count(regions.begin(), regions.end(), 1)));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return sizes[i] < sizes[j]; });
  std::vector<std::size_t> result(number_of_regions, Walled_regions_3::outside);
  std::vector<std::size_t> outermost(number_of_regions, Walled_regions_3::outside);
  for (std::size_t c : order) {
    // All regions enclosed by the smaller cell must be enclosed by the larger one.
    std::map<std::size_t, std::size_t> overlaps;
    for (std::size_t r = 0; r < number_of_regions; ++r)
      if (enclosed[c][r] && outermost[r] != Walled_regions_3::outside)
        ++overlaps[outermost[r]];
    for (const auto& [other, common] : overlaps)
      if (common != sizes[other] || common == sizes[c])
        refuse_surface(Invalid_surface_error::Reason::crossing_surfaces,
                       (std::min)(cells[other].surface, cells[c].surface),
                       (std::max)(cells[other].surface, cells[c].surface), {}, {});
    for (std::size_t r = 0; r < number_of_regions; ++r)
      if (enclosed[c][r]) {
        outermost[r] = c;
        if (result[r] == Walled_regions_3::outside)
          result[r] = c;
      }
  }
  return result;
}

// Divides space by closed surfaces that may share walls. The walls need not have the same
// triangulation. Throws Invalid_surface_error if surfaces are not closed, or overlap.
inline Walled_regions_3 divide_by_walls(const std::vector<Cell_surface_3>& cells) {
  std::vector<Merged_soup_3> merged;
  for (const Cell_surface_3& cell : cells) {
    merged.push_back(merge_points(cell.soup));
    check_closedness(merged.back(), cell.surface);
    const Joined_soup_3 alone = join({merged.back()});
    if (const auto pairs = crossing_triangles(alone); !pairs.empty())
      refuse_surface(Invalid_surface_error::Reason::self_intersection, cell.surface,
                     {pairs.front().first, pairs.front().second});
  }
  const Joined_soup_3 joined = join(merged);
  const std::optional<Split_soup_3> split = split_at_crossings(joined);
  if (!split)
    refuse_surface(Invalid_surface_error::Reason::crossing_surfaces, cells.front().surface,
                   cells.back().surface, {}, {});
  Walled_regions_3 result;
  std::vector<std::size_t> index;
  result.soup = {split->points, distinct_triangles(split->triangles, index)};
  const Soup_regions_3 regions(result.soup);
  std::vector<std::vector<char>> is_of(cells.size(),
                                       std::vector<char>(result.soup.triangles.size(), 0));
  for (std::size_t piece = 0; piece < index.size(); ++piece) {
    char& is_of_cell = is_of[joined.triangle_origins[split->origins[piece]].surface][index[piece]];
    is_of_cell = !is_of_cell;
  }
  std::vector<std::vector<char>> enclosed;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    Progress_scope::check();
    const auto by_cell = regions.enclosed_by(is_of[c]);
    if (!by_cell)
      refuse_surface(Invalid_surface_error::Reason::non_manifold_edge, cells[c].surface);
    enclosed.push_back(*by_cell);
  }
  const std::vector<std::size_t> innermost = innermost_cells(enclosed, cells, regions.size());
  for (std::size_t t = 0; t < result.soup.triangles.size(); ++t)
    result.sides.push_back({innermost[regions.behind(t)], innermost[regions.in_front_of(t)]});
  return result;
}

} // namespace internal

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
