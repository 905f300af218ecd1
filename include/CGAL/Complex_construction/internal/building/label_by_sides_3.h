// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Complex_construction, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_LABEL_BY_SIDES_3_H
#define CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_LABEL_BY_SIDES_3_H

#include <CGAL/Complex_construction/Tetrahedralization_3.h>
#include <CGAL/Complex_construction/internal/building/Boxed_soup_3.h>
#include <CGAL/Complex_construction/internal/building/label_cells.h>
#include <CGAL/Triangle_soup_repair/Invalid_surface_error.h>
#include <CGAL/Triangle_soup_repair/internal/checks/refuse_surface.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A cell on one side of a triangle.
struct Cell_at_triangle_3
{
  std::size_t triangle, cell;
  bool is_in_front; // whether the corners of the triangle are counterclockwise, seen from the cell
};

// Returns the two cells of each triangle of a soup, in increasing order of triangles.
// \pre The triangles are facets of the mesh.
inline std::vector<Cell_at_triangle_3> cells_at_triangles(const Tetrahedralization_3& mesh,
                                                          const Triangle_soup_3& soup) {
  std::vector<Wall<3>> triangles;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    triangles.push_back(make_wall(soup.triangles[t], t));
  std::sort(triangles.begin(), triangles.end());
  const auto point = [&](std::size_t i) { return exact_point(mesh.points[i]); };
  std::vector<Cell_at_triangle_3> result;
  for (const auto& facet : sorted_facets(mesh.tetrahedra)) {
    const auto found =
        std::lower_bound(triangles.begin(), triangles.end(), Wall<3>{facet.vertices, 0});
    if (found == triangles.end() || found->vertices != facet.vertices)
      continue;
    const Triangle_indices& t = soup.triangles[found->surface];
    const auto opposite = mesh.tetrahedra[facet.cell][facet.index];
    result.push_back(
        {found->surface, facet.cell,
         orientation(point(t[0]), point(t[1]), point(t[2]), point(opposite)) == POSITIVE});
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const auto& a, const auto& b) { return a.triangle < b.triangle; });
  return result;
}

// The labels behind and in front of the triangles of a patch.
using Labels_of_sides = std::array<int, 2>;

// Returns the label of each cell, given by the labels of the two sides of the patches. Throws
// `Invalid_surface_error` if two patches give different labels to the same region.
inline std::vector<int> label_by_sides(const Tetrahedralization_3& mesh, const Boxed_soup_3& boxed,
                                       const std::vector<Labels_of_sides>& sides) {
  const auto& origins = boxed.soup.triangle_origins;
  const auto cells = cells_at_triangles(mesh, boxed.soup);
  std::vector<std::pair<std::size_t, int>> seeds;
  for (const auto& c : cells)
    seeds.emplace_back(c.cell, sides[origins[c.triangle].surface][c.is_in_front]);
  std::optional<Contradicting_seeds> contradicting;
  auto labels = label_cells_by_seeds<3>(mesh.tetrahedra, boxed.walls(), seeds, contradicting);
  if (contradicting) {
    const auto first = origins[cells[contradicting->first].triangle],
               second = origins[cells[contradicting->second].triangle];
    refuse_surface(Invalid_surface_error::Reason::contradicting_sides, first.surface,
                   second.surface, {first.index, second.index}, {});
  }
  return labels;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_LABEL_BY_SIDES_3_H
