// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_BUILDING_TRIANGLE_SOUP_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_BUILDING_TRIANGLE_SOUP_3_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// What is passed to tetrahedralizers.
using Coordinates_3 = std::array<double, 3>;
using Triangle_indices = std::array<std::size_t, 3>;

template <class Point> Coordinates_3 coordinates(const Point& p) {
  return {to_double(p.x()), to_double(p.y()), to_double(p.z())};
}

struct Triangle_soup_3
{
  std::vector<Coordinates_3> points;
  std::vector<Triangle_indices> triangles;
};

// What exact predicates are asked about.
using Predicates_kernel = Exact_predicates_inexact_constructions_kernel;

inline Predicates_kernel::Point_3 exact_point(const Coordinates_3& p) { return {p[0], p[1], p[2]}; }

inline Predicates_kernel::Triangle_3 exact_triangle(const Triangle_soup_3& soup, std::size_t i) {
  const Triangle_indices& t = soup.triangles[i];
  return {exact_point(soup.points[t[0]]), exact_point(soup.points[t[1]]),
          exact_point(soup.points[t[2]])};
}

// Triangle i is triangle i of the input, point j is point `input_points[j]` of the input.
struct Merged_soup_3 : Triangle_soup_3
{
  std::vector<std::size_t> input_points; // increasing
};

// Keeps the first one of equal points, and no points that are in no triangle. Indices must be valid
// and coordinates finite. n log n.
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

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_BUILDING_TRIANGLE_SOUP_3_H
