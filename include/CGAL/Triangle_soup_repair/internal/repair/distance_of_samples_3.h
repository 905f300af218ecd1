// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_REPAIR_DISTANCE_OF_SAMPLES_3_H
#define CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_REPAIR_DISTANCE_OF_SAMPLES_3_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/internal/cgal/cgal_compat.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Triangle_soup_3.h>

#include <CGAL/AABB_tree.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the largest distance of a sample of a soup from the triangles of another soup. The
// samples are the corners of the triangles and, where edges are longer than `spacing`, the points
// of a grid in the triangle.
inline double distance_of_samples(const Triangle_soup_3& soup, const Triangle_soup_3& other,
                                  double spacing) {
  using Kernel = Predicates_kernel;
  using Triangles = std::vector<Kernel::Triangle_3>;
  static constexpr double most_parts = 20; // maximum along an edge, for needles
  static constexpr std::size_t none = std::size_t(-1);
  using Tree = AABB_tree<Tree_traits_3<Kernel, Triangles::const_iterator>>;
  const Triangle_soup_3 merged = merge_points(other);
  Triangles triangles;
  std::vector<std::size_t> corner_of(merged.points.size(), none); // a triangle of each point
  for (std::size_t t = 0; t < merged.triangles.size(); ++t)
    if (!exact_triangle(merged, t).is_degenerate()) {
      for (std::size_t v : merged.triangles[t])
        corner_of[v] = triangles.size();
      triangles.push_back(exact_triangle(merged, t));
    }
  Tree tree(triangles.cbegin(), triangles.cend());
  // Distinct points, because a search tree of many equal points is never completed.
  std::vector<Tree::Point_and_primitive_id> corners;
  for (std::size_t v = 0; v < corner_of.size(); ++v)
    if (corner_of[v] != none)
      corners.emplace_back(exact_point(merged.points[v]), triangles.cbegin() + corner_of[v]);
  tree.accelerate_distance_queries(corners.begin(), corners.end());

  double largest = 0;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    Progress_scope::check();
    const Kernel::Triangle_3 triangle = exact_triangle(soup, t);
    const auto a = triangle[0];
    const auto ab = triangle[1] - a, ac = triangle[2] - a;
    const double longest = std::sqrt((std::max)(
        {ab.squared_length(), ac.squared_length(), (triangle[2] - triangle[1]).squared_length()}));
    const int n = int(std::clamp(std::ceil(longest / spacing), 1., most_parts));
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j)
        largest = (std::max)(
            largest, tree.squared_distance(a + (double(i) / n) * ab + (double(j) / n) * ac));
  }
  return std::sqrt(largest);
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_REPAIR_DISTANCE_OF_SAMPLES_3_H
