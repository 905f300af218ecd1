// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_SHEETS_SHEET_SEAMS_3_H
#define CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_SHEETS_SHEET_SEAMS_3_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/Point_cloud_3.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/cloud_properties_3.h>
#include <CGAL/Solid_reconstruction_3/internal/sheets/Sheet_triangles_3.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns whether the angle between two triangles at an edge is less than 90 degrees.
inline bool is_fold(const Cloud_kernel::Point_3& v, const Cloud_kernel::Point_3& w,
                    const Cloud_kernel::Point_3& a, const Cloud_kernel::Point_3& b) {
  return cross_product(w - v, a - v) * cross_product(w - v, b - v) > 0;
}

// Returns whether a triangle can be added to a sheet: it has an edge on the boundary, all its edges
// have at most one other triangle, and it makes no fold.
inline bool continues_sheet(const std::vector<Cloud_kernel::Point_3>& points,
                            const Sheet_triangles_3& sheet, const Sheet_triangles_3::Triangle& t) {
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

// Closes the seams of a sheet. An advancing front is oriented. On a one-sided surface, it leaves a
// strip of missing triangles where it meets itself with the opposite orientation. There, the sheet
// has a boundary and the cloud has none. The strip is closed by facets between boundary vertices,
// in their order.
inline void close_seams(const Point_cloud_3& cloud,
                        const std::vector<Cloud_kernel::Point_3>& points,
                        const std::vector<Sheet_triangles_3::Triangle>& facets,
                        Sheet_triangles_3& sheet) {
  std::vector<char> is_on_boundary(points.size(), 0), is_on_seam(points.size(), 0);
  for (const auto& [v, w] : sheet.boundary())
    for (std::size_t u : {v, w})
      if (std::exchange(is_on_boundary[u], 1) == 0)
        is_on_seam[u] = !is_boundary_point(cloud, u);
  std::vector<Sheet_triangles_3::Triangle> candidates;
  for (const auto& t : facets) {
    const auto number = [&](const std::vector<char>& marks) {
      return marks[t[0]] + marks[t[1]] + marks[t[2]];
    };
    if (number(is_on_boundary) == 3 && number(is_on_seam) > 0)
      candidates.push_back(t);
  }
  for (bool goes_on = true; std::exchange(goes_on, false);)
    for (const auto& t : candidates) {
      Progress_scope::check();
      if (continues_sheet(points, sheet, t)) {
        sheet.add(t);
        goes_on = true;
      }
    }
}

// Fills holes with three or four edges, which noise leaves. They are smaller than a hole that the
// points can show.
inline void fill_small_holes(const std::vector<Cloud_kernel::Point_3>& points,
                             Sheet_triangles_3& sheet) {
  static constexpr std::size_t fewest = 16; // triangles; a smaller sheet has no holes
  if (sheet.all().size() < fewest)
    return;
  std::map<std::size_t, std::vector<std::size_t>> neighbors; // along the boundary
  for (const auto& [v, w] : sheet.boundary()) {
    neighbors[v].push_back(w);
    neighbors[w].push_back(v);
  }
  std::vector<std::size_t> loop;
  for (const auto& [first, around] : neighbors) {
    loop = {first};
    std::size_t last = first, v = around[0];
    while (v != first && loop.size() <= 4 && neighbors[v].size() == 2) {
      loop.push_back(v);
      const auto& next = neighbors[v];
      last = std::exchange(v, next[next[0] == last ? 1 : 0]);
    }
    if (v != first || around.size() != 2 || loop.size() > 4 ||
        *std::min_element(loop.begin(), loop.end()) != first)
      continue;
    if (loop.size() == 3 && sheet.opposite(loop[0], loop[1])[0] != loop[2])
      sheet.add({loop[0], loop[1], loop[2]});
    if (loop.size() == 4 && sheet.opposite(loop[0], loop[2]).empty() &&
        sheet.opposite(loop[1], loop[3]).empty()) {
      if (squared_distance(points[loop[1]], points[loop[3]]) <
          squared_distance(points[loop[0]], points[loop[2]]))
        std::rotate(loop.begin(), loop.begin() + 1, loop.end());
      sheet.add({loop[0], loop[1], loop[2]});
      sheet.add({loop[0], loop[2], loop[3]});
    }
  }
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_SHEETS_SHEET_SEAMS_3_H
