// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_LABEL_CELLS_H
#define CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_LABEL_CELLS_H

#include <CGAL/Complex_construction/Tetrahedralization_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/assemble_triangulation.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <limits>
#include <optional>
#include <tuple>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A facet of a closed surface, or of a closed curve in 2D. Different surfaces do not cross. A facet
// that several surfaces share is a wall of each of them.
template <int d> struct Wall
{
  std::array<std::size_t, d> vertices; // sorted
  std::size_t surface;

  friend bool operator<(const Wall& a, const Wall& b) {
    return std::tie(a.vertices, a.surface) < std::tie(b.vertices, b.surface);
  }
};

template <std::size_t d>
Wall<int(d)> make_wall(std::array<std::size_t, d> vertices, std::size_t surface) {
  std::sort(vertices.begin(), vertices.end());
  return {vertices, surface};
}

// The neighbor of a cell behind a facet, and the walls between them.
struct Facet_side
{
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  std::size_t cell = none; // none if the facet is on the boundary of the mesh
  std::size_t first_wall = 0, number_of_walls = 0;
};
template <int d> using Facet_sides = std::array<Facet_side, d + 1>;

// Returns the sides of all cells. Throws `Tetrahedralization_error` unless each wall is the common
// facet of two cells.
// \pre The walls are sorted.
template <int d>
std::vector<Facet_sides<d>> find_sides(const std::vector<Cell_vertices<d>>& cells,
                                       const std::vector<Wall<d>>& walls) {
  std::size_t walls_found = 0;
  std::vector<Facet_sides<d>> sides(cells.size());
  const auto facets = sorted_facets(cells);
  for (std::size_t i = 1; i < facets.size(); ++i) {
    Progress_scope::check();
    const auto &f = facets[i - 1], &g = facets[i];
    if (f.vertices != g.vertices)
      continue;
    Facet_side &behind_f = sides[f.cell][f.index], &behind_g = sides[g.cell][g.index];
    behind_f.cell = g.cell;
    behind_g.cell = f.cell;
    auto wall = std::lower_bound(walls.begin(), walls.end(), Wall<d>{f.vertices, 0});
    behind_f.first_wall = behind_g.first_wall = std::size_t(wall - walls.begin());
    for (; wall != walls.end() && wall->vertices == f.vertices; ++wall) {
      ++behind_f.number_of_walls;
      ++behind_g.number_of_walls;
      ++walls_found;
    }
  }
  if (walls_found != walls.size())
    throw Tetrahedralization_error("facets of the input are missing in its tetrahedral mesh: use "
                                   "another tetrahedralizer, or remesh the input");
  return sides;
}

// Puts all cells that are connected with `first` without crossing a wall, and were not visited,
// into `region`. Appends the sides behind the walls of the region to `entrances`.
template <int d, class Entrances>
void gather_region(const std::vector<Facet_sides<d>>& sides, std::size_t first,
                   std::vector<char>& is_visited, std::vector<std::size_t>& region,
                   Entrances& entrances) {
  region = {first};
  is_visited[first] = 1;
  for (std::size_t i = 0; i < region.size(); ++i) {
    Progress_scope::check();
    for (const Facet_side& side : sides[region[i]]) {
      if (side.cell == Facet_side::none || is_visited[side.cell])
        continue;
      if (side.number_of_walls > 0) {
        entrances.push_back(side);
      } else {
        is_visited[side.cell] = 1;
        region.push_back(side.cell);
      }
    }
  }
}

// Returns the label of each cell. A traversal starts at the boundary of the mesh and crosses as few
// walls as possible. A cell gets the label of the surface that was entered last and has not been
// left; outside all surfaces the label is 0. Crossing a wall leaves its surface if the traversal is
// inside it, and enters it otherwise. Orientations therefore do not matter, and a component nested
// in another component of the same surface bounds a cavity. Complexity: O(n log n).
template <int d>
std::vector<int> label_cells(const std::vector<Cell_vertices<d>>& cells, std::vector<Wall<d>> walls,
                             const std::vector<int>& surface_labels) {
  std::sort(walls.begin(), walls.end());
  const std::vector<Facet_sides<d>> sides = find_sides(cells, walls);
  const auto is_on_boundary = [](const Facet_sides<d>& s) {
    return std::any_of(s.begin(), s.end(),
                       [](const Facet_side& side) { return side.cell == Facet_side::none; });
  };

  // A region is a set of cells connected without crossing a wall. Its surfaces are the ones that
  // contain it, in the order in which the traversal entered them.
  std::vector<std::vector<std::size_t>> surfaces_of_regions;
  std::vector<Facet_side> entrances;
  std::vector<std::size_t> region, region_of_entrance;
  std::vector<int> labels(cells.size(), 0);
  std::vector<char> is_visited(cells.size(), 0);

  const auto fill = [&](std::size_t first, std::vector<std::size_t> surfaces) {
    gather_region<d>(sides, first, is_visited, region, entrances);
    for (std::size_t c : region)
      labels[c] = surfaces.empty() ? 0 : surface_labels[surfaces.back()];
    region_of_entrance.resize(entrances.size(), surfaces_of_regions.size());
    surfaces_of_regions.push_back(std::move(surfaces));
  };

  fill(std::find_if(sides.begin(), sides.end(), is_on_boundary) - sides.begin(), {});
  for (std::size_t i = 0; i < entrances.size(); ++i) {
    const Facet_side entrance = entrances[i];
    if (is_visited[entrance.cell])
      continue;
    std::vector<std::size_t> surfaces = surfaces_of_regions[region_of_entrance[i]], entered;
    for (std::size_t w = 0; w < entrance.number_of_walls; ++w) {
      const std::size_t surface = walls[entrance.first_wall + w].surface;
      const auto left = std::find(surfaces.begin(), surfaces.end(), surface);
      if (left != surfaces.end())
        surfaces.erase(left);
      else
        entered.push_back(surface);
    }
    surfaces.insert(surfaces.end(), entered.begin(), entered.end());
    fill(entrance.cell, std::move(surfaces));
  }
  return labels;
}

// Indices of two seeds with different labels in the same region.
struct Contradicting_seeds
{
  std::size_t first, second;
};

// Returns the label of each cell: the label of the seed in its region, or 0 if the region has no
// seed. A region is a set of cells connected without crossing a wall. If two seeds disagree,
// `contradicting` gets the first such pair. Complexity: O(n log n).
template <int d>
std::vector<int> label_cells_by_seeds(const std::vector<Cell_vertices<d>>& cells,
                                      std::vector<Wall<d>> walls,
                                      const std::vector<std::pair<std::size_t, int>>& seeds,
                                      std::optional<Contradicting_seeds>& contradicting) {
  std::sort(walls.begin(), walls.end());
  const std::vector<Facet_sides<d>> sides = find_sides(cells, walls);
  std::vector<std::size_t> seed_of_cell(cells.size());
  std::vector<char> is_visited(cells.size(), 0);
  std::vector<std::size_t> region;
  std::vector<Facet_side> entrances;
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const auto [cell, label] = seeds[i];
    if (is_visited[cell]) {
      if (seeds[seed_of_cell[cell]].second != label && !contradicting)
        contradicting = {seed_of_cell[cell], i};
      continue;
    }
    gather_region<d>(sides, cell, is_visited, region, entrances);
    for (std::size_t c : region)
      seed_of_cell[c] = i;
  }
  std::vector<int> labels(cells.size(), 0);
  for (std::size_t c = 0; c < cells.size(); ++c)
    if (is_visited[c])
      labels[c] = seeds[seed_of_cell[c]].second;
  return labels;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_LABEL_CELLS_H
