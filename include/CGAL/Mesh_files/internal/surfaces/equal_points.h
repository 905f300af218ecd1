// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Mesh_files, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MESH_FILES_INTERNAL_SURFACES_EQUAL_POINTS_H
#define CGAL_MESH_FILES_INTERNAL_SURFACES_EQUAL_POINTS_H

#include <CGAL/Mesh_support/internal/sets/equal_points.h>
#include <CGAL/Triangle_soup_repair/Labeled_surface_3.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns, for each point of a surface, the index of the first point with the same coordinates.
template <class Point>
std::vector<std::size_t> first_equal_points_of(const Labeled_surface_3<Point>& surface) {
  std::vector<std::array<double, 3>> coordinates;
  coordinates.reserve(surface.points.size());
  for (const Point& p : surface.points)
    coordinates.push_back({to_double(p.x()), to_double(p.y()), to_double(p.z())});
  return first_equal_points(coordinates);
}

// Merges points with the same coordinates. The order is that of the first points.
template <class Point> void merge_equal_points(Labeled_surface_3<Point>& surface) {
  std::vector<Point>& points = surface.points;
  std::vector<std::size_t> place = first_equal_points_of(surface);
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
