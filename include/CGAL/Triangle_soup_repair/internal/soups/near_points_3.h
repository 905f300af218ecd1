// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Triangle_soup_repair, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_SOUPS_NEAR_POINTS_3_H
#define CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_SOUPS_NEAR_POINTS_3_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Triangle_soup_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

enum class Merged_points { OF_OPEN_EDGES, ALL };

// Merges points closer to each other than a distance. All points are merged, or only the ends of
// open edges. For the latter, the distance is also bounded by a tenth of the length of the open
// edges at the point. A point is merged with the first point found near it. Returns the number of
// merged points.
inline std::size_t merge_near_points(Triangle_soup_3& soup, double distance, Merged_points which) {
  static constexpr double part = .1; // of the shortest open edge: its ends are never merged
  std::map<std::size_t, double> squared_limits;
  for_each_edge(sorted_sides(soup.triangles), [&](auto side, std::size_t number) {
    if (which == Merged_points::OF_OPEN_EDGES && number % 2 == 0)
      return;
    const double squared_length = squared_distance(exact_point(soup.points[side->vertices[0]]),
                                                   exact_point(soup.points[side->vertices[1]]));
    for (std::size_t v : side->vertices) {
      double& limit = squared_limits.emplace(v, distance * distance).first->second;
      if (which == Merged_points::OF_OPEN_EDGES)
        limit = (std::min)(limit, part * part * squared_length);
    }
  });

  // Points close to each other are in the same or in adjacent boxes of a grid.
  using Box = std::array<double, 3>;
  std::map<Box, std::vector<std::size_t>> grid;
  const auto find_near = [&](std::size_t v, const Box& box, double limit) {
    for (int k = 0; k < 27; ++k) {
      const auto found =
          grid.find({box[0] + k % 3 - 1, box[1] + k / 3 % 3 - 1, box[2] + k / 9 - 1});
      if (found == grid.end())
        continue;
      for (std::size_t w : found->second)
        if (squared_distance(exact_point(soup.points[v]), exact_point(soup.points[w])) <
            (std::min)(limit, squared_limits.at(w)))
          return w;
    }
    return v;
  };
  std::size_t merged = 0;
  for (const auto& [v, limit] : squared_limits) {
    Progress_scope::check();
    Box box;
    for (std::size_t i = 0; i < 3; ++i)
      box[i] = std::floor(soup.points[v][i] / distance);
    const std::size_t near = find_near(v, box, limit);
    if (near == v)
      grid[box].push_back(v);
    soup.points[v] = soup.points[near];
    merged += near != v;
  }
  return merged;
}

// Returns the mean side length of non-degenerate triangles; 0 without any.
inline double mean_side(const Triangle_soup_3& soup) {
  double sum = 0;
  std::size_t number = 0;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    if (exact_triangle(soup, t).is_degenerate())
      continue;
    const Triangle_indices& v = soup.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const Coordinates_3 &a = soup.points[v[i]], &b = soup.points[v[(i + 1) % 3]];
      sum += std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }
    number += 3;
  }
  return number == 0 ? 0 : sum / double(number);
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_SOUPS_NEAR_POINTS_3_H
