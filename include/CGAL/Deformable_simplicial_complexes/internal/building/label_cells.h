// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BUILDING_LABEL_CELLS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BUILDING_LABEL_CELLS_H

#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/assemble_triangulation.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// A facet of one of several closed surfaces, or curves in the plane, that do not cross.
template <int d> struct Wall
{
  std::array<std::size_t, d> vertices; // sorted
  std::size_t surface;

  friend bool operator<(const Wall& a, const Wall& b) { return a.vertices < b.vertices; }
};

template <std::size_t d>
Wall<int(d)> make_wall(std::array<std::size_t, d> vertices, std::size_t surface) {
  std::sort(vertices.begin(), vertices.end());
  return {vertices, surface};
}

// What is behind a facet of a cell.
struct Facet_side
{
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  std::size_t cell = none;    // none: the facet is on the boundary of the mesh
  std::size_t surface = none; // none: the facet is no wall
};
template <int d> using Facet_sides = std::array<Facet_side, d + 1>;

// Throws Tetrahedralization_error unless each wall is a facet of two cells.
template <int d>
std::vector<Facet_sides<d>> find_sides(const std::vector<Cell_vertices<d>>& cells,
                                       std::vector<Wall<d>> walls) {
  std::sort(walls.begin(), walls.end());
  std::size_t walls_found = 0;
  std::vector<Facet_sides<d>> sides(cells.size());
  const auto facets = sorted_facets(cells);
  for (std::size_t i = 1; i < facets.size(); ++i) {
    const auto &f = facets[i - 1], &g = facets[i];
    if (f.vertices != g.vertices)
      continue;
    Facet_side &behind_f = sides[f.cell][f.index], &behind_g = sides[g.cell][g.index];
    behind_f.cell = g.cell;
    behind_g.cell = f.cell;
    const auto wall = std::lower_bound(walls.begin(), walls.end(), Wall<d>{f.vertices, 0});
    if (wall != walls.end() && wall->vertices == f.vertices) {
      behind_f.surface = behind_g.surface = wall->surface;
      ++walls_found;
    }
  }
  if (walls_found != walls.size())
    throw Tetrahedralization_error("facets of the input are missing in the mesh made of it: use "
                                   "another tetrahedralizer, or remesh the input");
  return sides;
}

// The label of each cell, found by walking in from the boundary of the mesh through as few
// walls as possible: that of the surface that was entered last and not left again, 0 outside all
// surfaces. A step through a wall leaves its surface if it is inside, and enters it otherwise:
// orientations do not matter, and a surface nested in itself bounds a cavity. n log n.
template <int d>
std::vector<int> label_cells(const std::vector<Cell_vertices<d>>& cells,
                             const std::vector<Wall<d>>& walls,
                             const std::vector<int>& surface_labels) {
  const std::vector<Facet_sides<d>> sides = find_sides(cells, walls);
  const auto is_on_boundary = [](const Facet_sides<d>& s) {
    return std::any_of(s.begin(), s.end(),
                       [](const Facet_side& side) { return side.cell == Facet_side::none; });
  };

  // A region is what can be reached without passing a wall; its surfaces are those it is inside of,
  // in the order in which they were entered.
  struct Entrance
  {
    std::size_t cell, surface, from_region;
  };
  std::vector<std::vector<std::size_t>> regions;
  std::vector<Entrance> entrances;
  std::vector<int> labels(cells.size(), 0);
  std::vector<char> is_visited(cells.size(), 0);
  std::vector<std::size_t> stack;

  const auto fill = [&](std::size_t first, std::vector<std::size_t> surfaces) {
    const int label = surfaces.empty() ? 0 : surface_labels[surfaces.back()];
    regions.push_back(std::move(surfaces));
    is_visited[first] = 1;
    stack.push_back(first);
    while (!stack.empty()) {
      const std::size_t t = stack.back();
      stack.pop_back();
      labels[t] = label;
      for (const Facet_side& side : sides[t]) {
        if (side.cell == Facet_side::none || is_visited[side.cell])
          continue;
        if (side.surface != Facet_side::none)
          entrances.push_back({side.cell, side.surface, regions.size() - 1});
        else {
          is_visited[side.cell] = 1;
          stack.push_back(side.cell);
        }
      }
    }
  };

  fill(std::find_if(sides.begin(), sides.end(), is_on_boundary) - sides.begin(), {});
  for (std::size_t i = 0; i < entrances.size(); ++i) {
    const Entrance entrance = entrances[i];
    if (is_visited[entrance.cell])
      continue;
    std::vector<std::size_t> surfaces = regions[entrance.from_region];
    const auto entered = std::find(surfaces.begin(), surfaces.end(), entrance.surface);
    if (entered != surfaces.end())
      surfaces.erase(entered);
    else
      surfaces.push_back(entrance.surface);
    fill(entrance.cell, std::move(surfaces));
  }
  return labels;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BUILDING_LABEL_CELLS_H
