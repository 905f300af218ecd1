// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Triangle_soup_repair, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_REPAIR_CLEAN_SOUP_3_H
#define CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_REPAIR_CLEAN_SOUP_3_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/internal/sets/Disjoint_sets.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Triangle_soup_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the triangles of a soup without its fins. A fin is a sheet of triangles connected through
// edges with exactly two triangles that has open edges and is attached to other triangles.
// \pre equal points are merged
inline std::vector<Triangle_indices> triangles_without_fins(const Triangle_soup_3& soup) {
  Disjoint_sets sheets(soup.triangles.size());
  const auto sides = sorted_sides(soup.triangles);
  const auto for_each_edge = [&sides](const auto& visit) {
    for (auto side = sides.cbegin(); side != sides.cend();) {
      const auto end = end_of_edge(side, sides.cend());
      visit(side, std::size_t(end - side));
      side = end;
    }
  };
  for_each_edge([&](auto side, std::size_t size) {
    if (size == 2)
      sheets.join(side[0].triangle, side[1].triangle);
  });
  std::vector<char> is_open(soup.triangles.size(), 0), is_attached(soup.triangles.size(), 0);
  for_each_edge([&](auto side, std::size_t size) {
    if (size == 1)
      is_open[sheets.find(side->triangle)] = 1;
    for (std::size_t i = 0; size > 2 && i < size; ++i)
      is_attached[sheets.find(side[i].triangle)] = 1;
  });
  std::vector<Triangle_indices> result;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    if (!is_open[sheets.find(t)] || !is_attached[sheets.find(t)])
      result.push_back(soup.triangles[t]);
  return result;
}

// Removes triangles in which a vertex occurs twice. Returns their number.
inline std::size_t remove_collapsed_triangles(Triangle_soup_3& soup) {
  auto& t = soup.triangles;
  const auto end = std::remove_if(t.begin(), t.end(), [](const Triangle_indices& v) {
    return v[0] == v[1] || v[1] == v[2] || v[2] == v[0];
  });
  const auto removed = std::size_t(t.end() - end);
  t.erase(end, t.end());
  return removed;
}

// Removes repeated triangles: one of several triangles with the same vertices is kept. Sheets of
// triangles that occur an even number of times, such as walls between touching components, are
// removed completely if this reduces the number of edges with an odd number of triangles. Returns
// the number of removed triangles.
inline std::size_t remove_repeated_triangles(Triangle_soup_3& soup) {
  const std::size_t before = soup.triangles.size();
  std::map<Triangle_indices, std::vector<std::size_t>> groups;
  for (std::size_t t = 0; t < before; ++t) {
    Triangle_indices v = soup.triangles[t];
    std::sort(v.begin(), v.end());
    groups[v].push_back(t);
  }
  std::vector<std::size_t> kept;
  for (const auto& [corners, group] : groups)
    kept.push_back(group.front());
  std::sort(kept.begin(), kept.end());
  std::vector<Triangle_indices> triangles;
  std::vector<char> is_even;
  for (std::size_t t : kept) {
    Triangle_indices v = soup.triangles[t];
    triangles.push_back(v);
    std::sort(v.begin(), v.end());
    is_even.push_back(groups[v].size() % 2 == 0);
  }

  // The sheets: triangles that occur an even number of times and share edges.
  std::vector<std::size_t> wall(triangles.size());
  std::iota(wall.begin(), wall.end(), std::size_t(0));
  const auto find = [&wall](std::size_t t) {
    while (wall[t] != t)
      t = wall[t] = wall[wall[t]];
    return t;
  };
  const std::vector<Triangle_side> sides = sorted_sides(triangles);
  const auto for_each_wall_edge = [&](const auto& visit) {
    for (auto side = sides.begin(); side != sides.end();) {
      const auto end = end_of_edge(side, sides.end());
      std::vector<std::size_t> even;
      for (auto s = side; s != end; ++s)
        if (is_even[s->triangle])
          even.push_back(s->triangle);
      if (!even.empty())
        visit(even, std::size_t(end - side));
      side = end;
    }
  };
  for_each_wall_edge([&](const std::vector<std::size_t>& even, std::size_t) {
    for (std::size_t t : even)
      wall[(std::max)(find(t), find(even.front()))] = (std::min)(find(t), find(even.front()));
  });
  std::vector<long> gain(triangles.size(),
                         0); // odd edges that become even without a sheet, less the reverse
  for_each_wall_edge([&](const std::vector<std::size_t>& even, std::size_t number) {
    gain[find(even.front())] += long(number % 2) - long((number - even.size()) % 2);
  });
  soup.triangles.clear();
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (!is_even[t] || gain[find(t)] <= 0)
      soup.triangles.push_back(triangles[t]);
  if (soup.triangles.empty()) // the soup is a single sheet with two sides
    soup.triangles = triangles;
  return before - soup.triangles.size();
}

enum class Merged_points { OF_OPEN_EDGES, ALL };

// Merges points closer to each other than a distance. All points are merged, or only the ends of
// open edges. For the latter, the distance is also bounded by a tenth of the length of the open
// edges at the point. A point is merged with the first point found near it. Returns the number of
// merged points.
inline std::size_t merge_near_points(Triangle_soup_3& soup, double distance, Merged_points which) {
  static constexpr double part = .1; // of the shortest open edge: its ends are never merged
  std::map<std::size_t, double> squared_limits;
  const auto sides = sorted_sides(soup.triangles);
  for (auto side = sides.begin(); side != sides.end();) {
    const auto end = end_of_edge(side, sides.end());
    if (which == Merged_points::ALL || (end - side) % 2 == 1) {
      const double squared_length = squared_distance(exact_point(soup.points[side->vertices[0]]),
                                                     exact_point(soup.points[side->vertices[1]]));
      for (std::size_t v : side->vertices) {
        double& limit = squared_limits.emplace(v, distance * distance).first->second;
        if (which == Merged_points::OF_OPEN_EDGES)
          limit = (std::min)(limit, part * part * squared_length);
      }
    }
    side = end;
  }

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

#endif // CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_REPAIR_CLEAN_SOUP_3_H
