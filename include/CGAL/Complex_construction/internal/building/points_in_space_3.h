// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_POINTS_IN_SPACE_3_H
#define CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_POINTS_IN_SPACE_3_H

#include <CGAL/Complex_construction/Octree_3.h>
#include <CGAL/Mesh_support/internal/cgal/cgal_compat.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Triangle_soup_3.h>

#include <CGAL/AABB_tree.h>

#include <cmath>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns points for tetrahedra away from triangles, in the box around the triangles: the centers
// of the leaves of an octree. The side of a leaf at a triangle is a half to one times `size` edges
// of an equilateral triangle of the same area. The center of a leaf has a distance of `distance`
// sides or more from all triangles, along some axis. If `most` is given, returns no points if they
// or the split blocks are more than `most`, or if a triangle is smaller than the smallest leaves.
inline std::vector<Coordinates_3> points_in_space(const std::vector<Coordinates_3>& points,
                                                  const std::vector<Triangle_indices>& triangles,
                                                  double size, double distance,
                                                  std::size_t most = std::size_t(-1)) {
  using Kernel = Predicates_kernel;
  using Triangles = std::vector<Kernel::Triangle_3>;
  Triangles facets;
  for (const auto& t : triangles)
    facets.emplace_back(exact_point(points[t[0]]), exact_point(points[t[1]]),
                        exact_point(points[t[2]]));
  const AABB_tree<Tree_traits_3<Kernel, Triangles::const_iterator>> tree(facets.begin(),
                                                                         facets.end());
  const Bbox_3 box = tree.bbox();
  Octree_3 octree(Octree_3::most_levels);
  const double unit = (std::max)({box.x_span(), box.y_span(), box.z_span()}) / octree.side();
  for (const auto& facet : facets) {
    const double length = std::sqrt(4 / std::sqrt(3.) * std::sqrt(facet.squared_area()));
    const int exponent = std::ilogb(size * length / unit);
    if (exponent < 0 && most < std::size_t(-1))
      return {};
    const unsigned level = unsigned(std::clamp(exponent, 0, int(octree.last_level()) - 1)) + 1;
    const auto center = centroid(facet);
    Octree_3::Place block;
    for (int axis = 0; axis < 3; ++axis)
      block[axis] =
          (std::min)(std::uint32_t((center[axis] - box.min(axis)) / unit), octree.side() - 1) >>
          level;
    octree.split(level, block);
  }
  if (!octree.complete(most))
    return {};
  std::vector<Coordinates_3> result;
  octree.for_each_leaf([&](unsigned level, const Octree_3::Place& block) {
    const double side = std::ldexp(unit, int(level)), d = distance * side;
    const Coordinates_3 p = {box.xmin() + side * (block[0] + .5),
                             box.ymin() + side * (block[1] + .5),
                             box.zmin() + side * (block[2] + .5)};
    if (do_overlap(exact_point(p).bbox(), box) &&
        !tree.do_intersect(
            Kernel::Iso_cuboid_3(p[0] - d, p[1] - d, p[2] - d, p[0] + d, p[1] + d, p[2] + d)))
      result.push_back(p);
  });
  if (result.size() > most)
    result.clear(); // triangles are much smaller than the distances between them
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_POINTS_IN_SPACE_3_H
