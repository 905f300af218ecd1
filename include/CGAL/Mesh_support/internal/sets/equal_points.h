// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_SUPPORT_INTERNAL_SETS_EQUAL_POINTS_H
#define CGAL_MESH_SUPPORT_INTERNAL_SETS_EQUAL_POINTS_H

#include <CGAL/Mesh_support/coordinates.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns, for each point, the index of the first point with the same coordinates. n log n.
// \pre no coordinate is NaN
template <std::size_t d>
std::vector<std::size_t> first_equal_points(const std::vector<std::array<double, d>>& points) {
  std::vector<std::size_t> order(points.size()), result(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return points[i] < points[j] || (!(points[j] < points[i]) && i < j);
  });
  for (std::size_t k = 0; k < order.size(); ++k)
    result[order[k]] =
        k > 0 && points[order[k]] == points[order[k - 1]] ? result[order[k - 1]] : order[k];
  return result;
}

// Merges equal points of cells: cells refer to the first one, and the others are removed. Does
// nothing if a coordinate is not finite or an index does not exist.
template <std::size_t d, class Point, std::size_t n>
void merge_equal_points(std::vector<Point>& points,
                        std::vector<std::array<std::size_t, n>>& cells) {
  std::vector<std::array<double, d>> coordinates;
  coordinates.reserve(points.size());
  for (const Point& p : points) {
    auto& x = coordinates.emplace_back();
    for (int axis = 0; axis < int(d); ++axis)
      x[axis] = to_double(p[axis]);
    if (!has_finite_coordinates(x))
      return;
  }
  const std::vector<std::size_t> first = first_equal_points(coordinates);
  std::vector<std::size_t> new_index(points.size());
  std::size_t number = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    new_index[i] = first[i] == i ? number++ : new_index[first[i]];
  if (number == points.size())
    return;
  for (const auto& cell : cells)
    if (*std::max_element(cell.begin(), cell.end()) >= points.size())
      return;
  for (auto& cell : cells)
    for (std::size_t& v : cell)
      v = new_index[v];
  for (std::size_t i = 0; i < points.size(); ++i)
    if (first[i] == i && new_index[i] != i)
      points[new_index[i]] = std::move(points[i]);
  points.erase(points.begin() + std::ptrdiff_t(number), points.end());
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_SUPPORT_INTERNAL_SETS_EQUAL_POINTS_H
