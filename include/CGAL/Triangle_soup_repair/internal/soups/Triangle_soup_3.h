// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_SOUPS_TRIANGLE_SOUP_3_H
#define CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_SOUPS_TRIANGLE_SOUP_3_H

#include <CGAL/Mesh_support/Progress_scope.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/number_utils.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <unordered_map>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The types in which soups are passed to tetrahedralizers.
using Coordinates_3 = std::array<double, 3>;
using Triangle_indices = std::array<std::size_t, 3>;

template <class Point> Coordinates_3 coordinates(const Point& p) {
  return {to_double(p.x()), to_double(p.y()), to_double(p.z())};
}

template <class Points> std::vector<Coordinates_3> all_coordinates(const Points& points) {
  std::vector<Coordinates_3> result;
  for (const auto& p : points)
    result.push_back(coordinates(p));
  return result;
}

struct Triangle_soup_3
{
  std::vector<Coordinates_3> points;
  std::vector<Triangle_indices> triangles;
};

// Returns the soups of labeled surfaces or patches.
template <class Surface>
std::vector<Triangle_soup_3> soups_of(const std::vector<Surface>& surfaces) {
  std::vector<Triangle_soup_3> result;
  for (const Surface& surface : surfaces)
    result.push_back({all_coordinates(surface.points), surface.triangles});
  return result;
}

// Number of boxes below which `box_self_intersection_d()` scans them without dividing them. With
// two sets, one small set would end the division of a large one.
inline constexpr std::ptrdiff_t undivided_boxes = 2000;

// The kernel of exact predicates on soups.
using Predicates_kernel = Exact_predicates_inexact_constructions_kernel;

inline Predicates_kernel::Point_3 exact_point(const Coordinates_3& p) { return {p[0], p[1], p[2]}; }

inline Predicates_kernel::Triangle_3 exact_triangle(const Triangle_soup_3& soup,
                                                    const Triangle_indices& t) {
  return {exact_point(soup.points[t[0]]), exact_point(soup.points[t[1]]),
          exact_point(soup.points[t[2]])};
}

inline Predicates_kernel::Triangle_3 exact_triangle(const Triangle_soup_3& soup, std::size_t i) {
  return exact_triangle(soup, soup.triangles[i]);
}

// A soup with unique points. Triangle i is triangle i of the input, point j is point
// `input_points[j]` of the input.
struct Merged_soup_3 : Triangle_soup_3
{
  std::vector<std::size_t> input_points; // in increasing order
};

// Merges equal points, keeping the first one, and removes points that belong to no triangle. Takes
// time O(n log n).
// \pre indices are valid and coordinates are finite
inline Merged_soup_3 merge_points(const Triangle_soup_3& input) {
  std::vector<char> is_used(input.points.size(), 0);
  for (const Triangle_indices& t : input.triangles)
    for (std::size_t i : t)
      is_used[i] = 1;

  std::vector<std::size_t> order(input.points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  order.erase(
      std::remove_if(order.begin(), order.end(), [&](std::size_t i) { return !is_used[i]; }),
      order.end());
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return input.points[i] < input.points[j]; });
  std::vector<std::size_t> first(input.points.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_equal = i > 0 && input.points[order[i - 1]] == input.points[order[i]];
    first[order[i]] = is_equal ? first[order[i - 1]] : order[i];
  }

  Merged_soup_3 merged;
  std::vector<std::size_t> index(input.points.size());
  for (std::size_t i = 0; i < input.points.size(); ++i)
    if (is_used[i] && first[i] == i) {
      index[i] = merged.points.size();
      merged.points.push_back(input.points[i]);
      merged.input_points.push_back(i);
    }
  merged.triangles.reserve(input.triangles.size());
  for (const Triangle_indices& t : input.triangles)
    merged.triangles.push_back({index[first[t[0]]], index[first[t[1]]], index[first[t[2]]]});
  return merged;
}

// Appends the points and triangles of another soup.
inline void append(Triangle_soup_3& soup, const Triangle_soup_3& other) {
  const std::size_t offset = soup.points.size();
  soup.points.insert(soup.points.end(), other.points.begin(), other.points.end());
  for (const Triangle_indices& t : other.triangles)
    soup.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
}

// The triangles of several surfaces, one surface after the other. Equal points are merged, also
// points of different surfaces.
struct Joined_soup_3 : Triangle_soup_3
{
  // The origin of a point or triangle: item `index` of surface `surface` of the input.
  struct Origin
  {
    std::size_t surface, index;
  };
  std::vector<Origin> point_origins; // the first of equal points; surfaces increase
  std::vector<Origin> triangle_origins;
};

inline Joined_soup_3 join(const std::vector<Merged_soup_3>& surfaces) {
  Triangle_soup_3 all;
  Joined_soup_3 joined;
  std::vector<Joined_soup_3::Origin> points;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    append(all, surfaces[s]);
    for (std::size_t i : surfaces[s].input_points)
      points.push_back({s, i});
    for (std::size_t t = 0; t < surfaces[s].triangles.size(); ++t)
      joined.triangle_origins.push_back({s, t});
  }
  Merged_soup_3 merged = merge_points(all);
  joined.points = std::move(merged.points);
  joined.triangles = std::move(merged.triangles);
  for (std::size_t i : merged.input_points)
    joined.point_origins.push_back(points[i]);
  return joined;
}

// A side of a triangle.
struct Triangle_side
{
  std::array<std::size_t, 2> vertices; // in increasing order
  std::size_t triangle, opposite_vertex;
};

// Returns the sides of all triangles, sorted so that the sides on an edge are consecutive, by
// increasing triangle index.
inline std::vector<Triangle_side> sorted_sides(const std::vector<Triangle_indices>& triangles) {
  std::vector<Triangle_side> sides;
  sides.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(triangles[t][i], triangles[t][(i + 1) % 3]);
      sides.push_back({{a, b}, t, triangles[t][(i + 2) % 3]});
    }
  std::sort(sides.begin(), sides.end(), [](const Triangle_side& a, const Triangle_side& b) {
    return a.vertices != b.vertices ? a.vertices < b.vertices : a.triangle < b.triangle;
  });
  return sides;
}

// Returns the end of the range of sides on the same edge as `first`, in a range of sorted sides.
inline std::vector<Triangle_side>::const_iterator
end_of_edge(std::vector<Triangle_side>::const_iterator first,
            std::vector<Triangle_side>::const_iterator end) {
  return std::find_if(
      first, end, [first](const Triangle_side& side) { return side.vertices != first->vertices; });
}

// Calls `visit(first, number)` with the first side on each edge and the number of sides on it.
template <class Visit>
void for_each_edge(const std::vector<Triangle_side>& sorted_sides, const Visit& visit) {
  for (auto side = sorted_sides.begin(); side != sorted_sides.end();) {
    const auto end = end_of_edge(side, sorted_sides.end());
    visit(side, std::size_t(end - side));
    side = end;
  }
}

// Returns whether a triangle has three different corners.
inline bool has_corners(const Triangle_indices& t) {
  return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
}

// Returns the corners in increasing order, which identify a triangle.
inline Triangle_indices sorted(Triangle_indices corners) {
  std::sort(corners.begin(), corners.end());
  return corners;
}

enum class Merged_points { OF_OPEN_EDGES, ALL };

// Merges points closer to each other than a distance. All points are merged, or only the ends of
// open edges. For the latter, the distance is also bounded by a tenth of the length of the open
// edges at the point. A point is merged with the first point found near it. Returns the number of
// merged points.
inline std::size_t merge_near_points(Triangle_soup_3& soup, double distance, Merged_points which) {
  static constexpr double part = .1; // of the shortest open edge: its ends are never merged
  static constexpr double none = -1; // of points that are not merged
  std::vector<double> squared_limits(soup.points.size(), none);
  for_each_edge(sorted_sides(soup.triangles), [&](auto side, std::size_t number) {
    if (which == Merged_points::OF_OPEN_EDGES && number % 2 == 0)
      return;
    const double squared_length = squared_distance(exact_point(soup.points[side->vertices[0]]),
                                                   exact_point(soup.points[side->vertices[1]]));
    for (std::size_t v : side->vertices) {
      double& limit = squared_limits[v];
      if (limit == none)
        limit = distance * distance;
      if (which == Merged_points::OF_OPEN_EDGES)
        limit = (std::min)(limit, part * part * squared_length);
    }
  });

  // Points close to each other are in the same or in adjacent boxes of a grid.
  using Box = std::array<double, 3>;
  std::unordered_map<Box, std::vector<std::size_t>, boost::hash<Box>> grid;
  const auto find_near = [&](std::size_t v, const Box& box, double limit) {
    for (int k = 0; k < 27; ++k) {
      const auto found =
          grid.find({box[0] + k % 3 - 1, box[1] + k / 3 % 3 - 1, box[2] + k / 9 - 1});
      if (found == grid.end())
        continue;
      for (std::size_t w : found->second)
        if (squared_distance(exact_point(soup.points[v]), exact_point(soup.points[w])) <
            (std::min)(limit, squared_limits[w]))
          return w;
    }
    return v;
  };
  std::size_t merged = 0;
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    Progress_scope::check();
    if (squared_limits[v] == none)
      continue;
    Box box;
    for (std::size_t i = 0; i < 3; ++i)
      box[i] = std::floor(soup.points[v][i] / distance);
    const std::size_t nearby = find_near(v, box, squared_limits[v]);
    if (nearby == v)
      grid[box].push_back(v);
    soup.points[v] = soup.points[nearby];
    merged += nearby != v;
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

#endif // CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_SOUPS_TRIANGLE_SOUP_3_H
