// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_MAKE_PATCHES_3_H
#define CGAL_TRIANGLE_SOUP_REPAIR_MAKE_PATCHES_3_H

#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Triangle_soup_repair/Invalid_surface_error.h>
#include <CGAL/Triangle_soup_repair/Labeled_surface_3.h>
#include <CGAL/Triangle_soup_repair/internal/arrangement/Flat_simplifier_3.h>
#include <CGAL/Triangle_soup_repair/internal/arrangement/divide_space_3.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Triangle_soup_3.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgTriangleSoupRepairRef

Options of `make_patches_3()` and `have_contacts_3()`.
*/
struct Patch_options_3
{
  /// Vertices, edges and triangles that are nearer to each other than this distance become common
  /// vertices, edges and triangles; in the unit of the coordinates, at least 0. By default 1e-12 of
  /// the largest coordinate or, if all coordinates are numbers of type `float` or have 6 to 12
  /// decimal digits, 6 units in its last place. If triangles cannot be welded at this default
  /// distance, or nothing is left of a surface, 1/16 to 16 times of it are tried.
  std::optional<double> weld_distance;

  /// Whether surfaces may overlap. The later one covers the earlier one where they do.
  bool allow_overlaps = true;

  /// Throws an exception unless all values are in their ranges.
  /// \throws Error if a value is out of its range
  void check() const {
    if (weld_distance && !(*weld_distance >= 0 && std::isfinite(*weld_distance)))
      throw Error("the weld distance is negative or not finite: use 0 or more");
  }
};

/*!
\ingroup PkgTriangleSoupRepairRef

The patches between the regions that closed surfaces bound, and the labels of these regions.
*/
template <class Point> struct Patches_of_surfaces_3
{
  std::vector<Labeled_patch_3<Point>> patches; ///< one for each pair of labels that share a wall
  /// labels of the regions of each surface; the first one is the label of the surface
  std::vector<std::vector<int>> labels;
  /// pairs of surfaces that overlap, each in increasing order
  std::vector<std::array<std::size_t, 2>> overlaps;
  /// surfaces of which nothing is left, since others cover them or they are thinner than the weld
  /// distance
  std::vector<std::size_t> covered;
  double weld_distance = 0; ///< the weld distance, in the unit of the coordinates
};

namespace internal {

// Returns the labels of the cells of surfaces. The first cell of a surface has the label of the
// surface, each of the others the next label that is not taken.
template <class Point>
std::vector<int> labels_of_cells(const std::vector<std::size_t>& surface_of_cell,
                                 const std::vector<Labeled_surface_3<Point>>& surfaces) {
  std::set<int> taken = {0};
  for (const auto& surface : surfaces)
    taken.insert(surface.label);
  std::vector<int> result;
  for (std::size_t c = 0; c < surface_of_cell.size(); ++c) {
    int label = surfaces[surface_of_cell[c]].label;
    if (c > 0 && surface_of_cell[c - 1] == surface_of_cell[c])
      while (!taken.insert(label).second)
        ++label;
    result.push_back(label);
  }
  return result;
}

// Returns the triangles between cells of different labels. The larger label is behind each
// triangle.
inline Walls_3 walls_between(const Divided_space_3& space, const std::vector<int>& labels) {
  const auto label_of = [&](std::size_t cell) {
    return cell == Covering_cells_3::none ? 0 : labels[cell];
  };
  Walls_3 result;
  result.points = space.soup.points;
  for (std::size_t t = 0; t < space.sides.size(); ++t) {
    std::array<int, 2> sides = {label_of(space.sides[t].behind), label_of(space.sides[t].in_front)};
    auto triangle = space.soup.triangles[t];
    if (sides[0] < sides[1]) {
      std::swap(sides[0], sides[1]);
      std::swap(triangle[1], triangle[2]);
    }
    if (sides[0] != sides[1]) {
      result.triangles.push_back(triangle);
      result.labels.push_back(sides);
      result.lengths.push_back(space.lengths[t]);
    }
  }
  return result;
}

// Returns the patches that walls consist of.
template <class Point> std::vector<Labeled_patch_3<Point>> patches_of(const Walls_3& walls) {
  std::map<std::array<int, 2>, Triangle_soup_3> soups; // by labels
  for (std::size_t t = 0; t < walls.triangles.size(); ++t)
    soups[walls.labels[t]].triangles.push_back(walls.triangles[t]);
  std::vector<Labeled_patch_3<Point>> result;
  for (auto& [sides, soup] : soups) {
    soup.points = walls.points;
    const auto merged = merge_points(soup);
    Labeled_patch_3<Point> patch;
    for (const auto& p : merged.points)
      patch.points.push_back(Point(p[0], p[1], p[2]));
    patch.triangles = merged.triangles;
    patch.label_behind = sides[0];
    patch.label_in_front = sides[1];
    result.push_back(std::move(patch));
  }
  return result;
}

} // namespace internal

/*!
\ingroup PkgTriangleSoupRepairRef

Makes patches from any closed surfaces, such as the boundaries of several materials, for
`make_deformable_simplicial_complex_3()`. n log n in the number of triangles, plus the pairs of
regions of cells that overlap.

Surfaces may touch, share walls, be nested or cross in any way: the triangulations of a wall in two
surfaces may be different. The innermost surface determines the label of a point; of several
surfaces that overlap otherwise, the last one does. Walls between regions of the same label are
ignored.

A single surface may have inner walls, too: triangles that occur twice, as between closed components
that touch, or edges of three triangles. Each bounded region of such a surface gets its own label.
The first region gets the label of the surface. The others get the next labels that no surface has,
in the order of their first triangles.

Features that are nearer to each other than the weld distance are merged. Then triangles are split
where they meet, with exact arithmetic. Points where they meet are rounded, and features are merged
again, until triangles meet in common vertices and edges only. So rounding opens no gap, and a wall
that two surfaces divide differently has the vertices of both, except where edges of a flat part or
a straight line are short beside others: needles are removed there.

\tparam Point a point type with `double` coordinates, such as that of `Labeled_surface_3`

\param surfaces the closed surfaces with their labels
\param options the weld distance, and whether surfaces may overlap
\return the patches, the labels of the regions, and the surfaces that overlap
\throws Invalid_surface_error if coordinates are not finite, indices are wrong, or a surface is not
        closed or intersects itself. If the options do not permit overlaps, also if surfaces
        overlap, or if they are equal.
\throws Error if the weld distance is out of range, or if triangles cannot be welded at this distance
\throws Interrupted_error if the callback of a `Progress_scope` returns `false`
\pre Labels are small enough that the labels of the additional regions are values of type `int`.
*/
template <class Point>
Patches_of_surfaces_3<Point> make_patches_3(const std::vector<Labeled_surface_3<Point>>& surfaces,
                                            const Patch_options_3& options = {}) {
  options.check();
  const internal::Divided_space_3 space =
      internal::divide_space(internal::soups_of(surfaces), options.weld_distance);
  if (!options.allow_overlaps && !space.overlaps.empty())
    internal::refuse_surface(Invalid_surface_error::Reason::crossing_surfaces,
                             space.overlaps.front()[0], space.overlaps.front()[1], {}, {});
  const std::vector<int> labels = internal::labels_of_cells(space.surfaces, surfaces);
  Patches_of_surfaces_3<Point> result;
  const internal::Walls_3 walls = internal::walls_between(space, labels);
  result.patches =
      internal::patches_of<Point>(internal::simplify_flat_parts(walls, space.weld_distance));
  result.labels.resize(surfaces.size());
  for (std::size_t c = 0; c < labels.size(); ++c)
    result.labels[space.surfaces[c]].push_back(labels[c]);
  result.overlaps = space.overlaps;
  result.covered = space.covered;
  result.weld_distance = space.weld_distance;
  return result;
}

/*!
\ingroup PkgTriangleSoupRepairRef

Returns whether features of surfaces nearly meet: whether vertices, edges and triangles that share
no vertex are nearer to each other than the weld distance. Then, a tetrahedralizer may fail although
the surfaces do not cross; call `make_patches_3()` first. n log n in the number of triangles.

\tparam Point a point type with `double` coordinates, such as that of `Labeled_surface_3`

\throws Invalid_surface_error if coordinates are not finite or indices are wrong
\throws Error if the weld distance is out of range
*/
template <class Point>
bool have_contacts_3(const std::vector<Labeled_surface_3<Point>>& surfaces,
                     const Patch_options_3& options = {}) {
  options.check();
  return internal::have_contacts(internal::soups_of(surfaces), options.weld_distance);
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_TRIANGLE_SOUP_REPAIR_MAKE_PATCHES_3_H
