// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Mesh_files, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MESH_FILES_INTERNAL_SURFACES_EQUAL_POINTS_H
#define CGAL_MESH_FILES_INTERNAL_SURFACES_EQUAL_POINTS_H

#include <CGAL/Triangle_soup_repair/Labeled_surface_3.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the index of the first point with the same coordinates as each point.
template <class Point>
std::vector<std::size_t> first_equal_points(const std::vector<Point>& points) {
  std::vector<std::size_t> order(points.size()), result(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return points[a] == points[b] ? a < b : points[a] < points[b];
  });
  for (std::size_t i = 0, first = 0; i < order.size(); ++i) {
    if (points[order[i]] != points[order[first]])
      first = i;
    result[order[i]] = order[first];
  }
  return result;
}

// Merges points with the same coordinates. The order is that of the first points.
template <class Point> void merge_equal_points(Labeled_surface_3<Point>& surface) {
  std::vector<Point>& points = surface.points;
  std::vector<std::size_t> place = first_equal_points(points);
  std::size_t n = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (place[i] == i) {
      points[n] = points[i];
      place[i] = n++;
    } else
      place[i] = place[place[i]];
  points.resize(n);
  points.shrink_to_fit();
  for (auto& triangle : surface.triangles)
    for (auto& corner : triangle)
      corner = place[corner];
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_FILES_INTERNAL_SURFACES_EQUAL_POINTS_H
