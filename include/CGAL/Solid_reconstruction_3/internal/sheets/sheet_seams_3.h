// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Solid_reconstruction_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_SHEETS_SHEET_SEAMS_3_H
#define CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_SHEETS_SHEET_SEAMS_3_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/Point_cloud_3.h>
#include <CGAL/Solid_reconstruction_3/internal/sheets/Sheet_front_3.h>
#include <CGAL/Solid_reconstruction_3/internal/sheets/Sheet_triangles_3.h>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns whether the angle between two triangles at an edge is less than 90 degrees.
inline bool is_fold(const Cloud_kernel::Point_3& v, const Cloud_kernel::Point_3& w,
                    const Cloud_kernel::Point_3& a, const Cloud_kernel::Point_3& b) {
  return cross_product(w - v, a - v) * cross_product(w - v, b - v) > 0;
}

// Returns whether a triangle can be added to a sheet: it has an edge on the boundary, all its edges
// have at most one other triangle, and it makes no fold.
inline bool continues_sheet(const std::vector<Cloud_kernel::Point_3>& points,
                            const Sheet_triangles_3& sheet, const Sheet_front_3::Triangle& t) {
  bool is_at_boundary = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t v = t[k], w = t[(k + 1) % 3];
    const std::vector<std::size_t> others = sheet.opposite(v, w);
    if (others.size() > 1)
      return false;
    if (others.empty())
      continue;
    if (is_fold(points[v], points[w], points[others[0]], points[t[(k + 2) % 3]]))
      return false;
    is_at_boundary = true;
  }
  return is_at_boundary;
}

// Orients triangles consistently, as far as possible.
inline void orient_sheet(const std::vector<Cloud_kernel::Point_3>& points,
                         std::vector<Sheet_front_3::Triangle>& triangles) {
  std::vector<Cloud_kernel::Point_3> copies = points; // CGAL adds copies of points to cut the soup
  std::vector<Sheet_front_3::Triangle> oriented = triangles;
  Polygon_mesh_processing::orient_polygon_soup(copies, oriented);
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    Sheet_front_3::Triangle& t = triangles[f];
    for (int k = 0; k < 2 && points[t[0]] != copies[oriented[f][0]]; ++k)
      std::rotate(t.begin(), t.begin() + 1, t.end());
    if (points[t[1]] != copies[oriented[f][1]])
      std::swap(t[1], t[2]);
  }
}

// Closes the seams of a sheet. An advancing front is oriented. On a one-sided surface, it leaves a
// strip of missing triangles where it meets itself with the opposite orientation. The strip is
// closed by Delaunay facets between boundary vertices, with the smallest empty balls first.
inline void close_seams(const std::vector<Cloud_kernel::Point_3>& points, Sheet_front_3& front) {
  Sheet_triangles_3 sheet(points.size(), front.triangles);
  std::vector<char> is_on_boundary(points.size(), 0);
  for (const auto& [v, w] : sheet.boundary())
    is_on_boundary[v] = is_on_boundary[w] = 1;
  std::vector<Sheet_front_3::Ball_facet> candidates;
  for (const auto& f : front.other_facets)
    if (std::all_of(f.triangle.begin(), f.triangle.end(),
                    [&](std::size_t v) { return is_on_boundary[v] != 0; }))
      candidates.push_back(f);
  std::sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
    return std::make_pair(a.squared_radius, a.triangle) <
           std::make_pair(b.squared_radius, b.triangle);
  });
  for (bool goes_on = true; std::exchange(goes_on, false);)
    for (const auto& c : candidates) {
      Progress_scope::check();
      if (continues_sheet(points, sheet, c.triangle)) {
        sheet.add(c.triangle);
        goes_on = true;
      }
    }
  const std::size_t first = front.triangles.size();
  std::vector<char> is_pinched(points.size(), 0);
  for (std::size_t i = first; i < sheet.all().size(); ++i)
    for (std::size_t v : sheet.all()[i])
      is_pinched[v] = !sheet.is_manifold_at(v);
  for (std::size_t i = first; i < sheet.all().size(); ++i) {
    const auto& t = sheet.all()[i];
    if (is_pinched[t[0]] == 0 && is_pinched[t[1]] == 0 && is_pinched[t[2]] == 0)
      front.triangles.push_back(t);
  }
  if (front.triangles.size() > first)
    orient_sheet(points, front.triangles);
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_SHEETS_SHEET_SEAMS_3_H
