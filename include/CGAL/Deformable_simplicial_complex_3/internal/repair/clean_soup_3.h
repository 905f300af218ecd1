// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_REPAIR_CLEAN_SOUP_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_REPAIR_CLEAN_SOUP_3_H

#include <CGAL/Deformable_simplicial_complex_3/internal/soups/Triangle_soup_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Removes triangles that have a corner twice. Returns their number.
inline std::size_t remove_collapsed_triangles(Triangle_soup_3& soup) {
  auto& t = soup.triangles;
  const auto end = std::remove_if(t.begin(), t.end(), [](const Triangle_indices& v) {
    return v[0] == v[1] || v[1] == v[2] || v[2] == v[0];
  });
  const auto removed = std::size_t(t.end() - end);
  t.erase(end, t.end());
  return removed;
}

// Of triangles with the same corners keeps the first one, unless as many of them are turned one way
// as the other: these are a wall between parts that touch. Returns how many were removed.
inline std::size_t remove_repeated_triangles(Triangle_soup_3& soup) {
  struct Group
  {
    std::size_t first, number;
    int balance; // of both orientations
  };
  std::map<Triangle_indices, Group> groups;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    Triangle_indices v = soup.triangles[t];
    std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
    const bool is_even = v[1] < v[2];
    if (!is_even)
      std::swap(v[1], v[2]);
    Group& group = groups.emplace(v, Group{t, 0, 0}).first->second;
    ++group.number;
    group.balance += is_even ? 1 : -1;
  }
  std::vector<std::size_t> kept;
  for (const auto& [corners, group] : groups)
    if (group.number == 1 || group.balance != 0)
      kept.push_back(group.first);
  std::sort(kept.begin(), kept.end());
  std::vector<Triangle_indices> triangles;
  for (std::size_t t : kept)
    triangles.push_back(soup.triangles[t]);
  const std::size_t removed = soup.triangles.size() - triangles.size();
  soup.triangles = std::move(triangles);
  return removed;
}

// Merges points of open edges that are nearer to each other than a distance and than a part of the
// edges there; a point is merged with the first one near. Returns how many were merged.
inline std::size_t merge_near_border_points(Triangle_soup_3& soup, double distance) {
  std::vector<std::size_t> border;
  const auto sides = sorted_sides(soup.triangles);
  for (auto side = sides.begin(); side != sides.end();) {
    const auto end = end_of_edge(side, sides.end());
    if ((end - side) % 2 == 1)
      border.insert(border.end(), side->vertices.begin(), side->vertices.end());
    side = end;
  }
  std::sort(border.begin(), border.end());
  border.erase(std::unique(border.begin(), border.end()), border.end());

  // Points near each other are in the same or in neighboring boxes of a grid.
  using Box = std::array<long long, 3>;
  std::map<Box, std::vector<std::size_t>> grid;
  std::size_t merged = 0;
  for (std::size_t v : border) {
    const Coordinates_3& p = soup.points[v];
    Box box;
    for (std::size_t i = 0; i < 3; ++i)
      box[i] = std::llround(p[i] / distance);
    bool is_new = true;
    for (int k = 0; k < 27 && is_new; ++k) {
      const Box near = {box[0] + k % 3 - 1, box[1] + k / 3 % 3 - 1, box[2] + k / 9 - 1};
      const auto found = grid.find(near);
      if (found == grid.end())
        continue;
      for (std::size_t w : found->second)
        if (is_new &&
            squared_distance(exact_point(p), exact_point(soup.points[w])) < distance * distance) {
          soup.points[v] = soup.points[w];
          is_new = false;
          ++merged;
        }
    }
    if (is_new)
      grid[box].push_back(v);
  }
  return merged;
}

// The mean length of the sides of all triangles; 0 without any.
inline double mean_side(const Triangle_soup_3& soup) {
  double sum = 0;
  for (const Triangle_indices& t : soup.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      sum += std::sqrt(squared_distance(exact_point(soup.points[t[i]]),
                                        exact_point(soup.points[t[(i + 1) % 3]])));
  return soup.triangles.empty() ? 0 : sum / (3. * double(soup.triangles.size()));
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_REPAIR_CLEAN_SOUP_3_H
