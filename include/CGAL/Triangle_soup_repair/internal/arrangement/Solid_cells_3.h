// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_ARRANGEMENT_SOLID_CELLS_3_H
#define CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_ARRANGEMENT_SOLID_CELLS_3_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/internal/sets/Disjoint_sets.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Soup_regions_3.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Triangle_soup_3.h>

#include <iterator>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Triangles that meet in common vertices and edges only, and the surfaces that contain each of
// them.
struct Shared_soup_3 : Triangle_soup_3
{
  // A surface, and how often it contains a triangle.
  using Share = std::pair<std::size_t, int>;

  std::vector<std::vector<Share>> shares; // of each triangle, surfaces in increasing order
  std::vector<std::size_t> first;         // the first such triangle of the soup
};

// Returns the distinct triangles of a soup.
// \param surfaces surface of each triangle
// \pre equal points are merged
inline Shared_soup_3 share_triangles(const Triangle_soup_3& soup,
                                     const std::vector<std::size_t>& surfaces) {
  Shared_soup_3 result;
  result.points = soup.points;
  std::map<Triangle_indices, std::size_t> known;
  std::vector<std::map<std::size_t, int>> shares;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    const auto [place, is_new] = known.emplace(sorted(soup.triangles[t]), result.triangles.size());
    if (is_new) {
      result.triangles.push_back(soup.triangles[t]);
      result.first.push_back(t);
      shares.emplace_back();
    }
    ++shares[place->second][surfaces[t]];
  }
  for (const auto& of_triangle : shares)
    result.shares.emplace_back(of_triangle.begin(), of_triangle.end());
  return result;
}

// The solids that surfaces enclose, here called cells, and which of them contain each region of
// space. A surface encloses one cell, where paths from outside cross it an odd number of times. A
// surface with walls encloses several, one for each region that it bounds; walls are triangles that
// it contains several times, or that have an edge with an odd number of its triangles.
class Solid_cells_3
{
public:
  // \param number number of surfaces
  // \pre each surface has an even number of triangles in each edge if triangles are counted as
  // often as it contains them, or it has walls
  Solid_cells_3(const Shared_soup_3& soup, std::size_t number)
      : m_soup(soup), m_regions(soup), m_cells_of(m_regions.size()) {
    const std::vector<char> has_walls = surfaces_with_walls(number);
    std::vector<std::size_t> cell_of(number); // of surfaces without walls
    for (std::size_t s = 0; s < number; ++s) {
      cell_of[s] = m_surfaces.size();
      if (has_walls[s])
        add_cells_between_walls(s);
      else
        m_surfaces.push_back(s);
    }
    const auto enclosing = enclosing_surfaces(has_walls);
    for (std::size_t r = 0; r < m_regions.size(); ++r) {
      for (std::size_t s : enclosing[r])
        m_cells_of[r].push_back(cell_of[s]);
      std::sort(m_cells_of[r].begin(), m_cells_of[r].end());
    }
  }

  const Soup_regions_3& regions() const { return m_regions; }

  // Returns the surface of each cell; surfaces increase.
  const std::vector<std::size_t>& surfaces() const { return m_surfaces; }

  // Returns the cells that contain a region, in increasing order.
  const std::vector<std::size_t>& cells_of(std::size_t region) const { return m_cells_of[region]; }

private:
  // Finds surfaces with repeated triangles, or with an odd number of triangles in an edge.
  std::vector<char> surfaces_with_walls(std::size_t number) const {
    std::vector<char> result(number, 0);
    for (std::size_t t = 0; t < m_soup.triangles.size(); ++t)
      if (m_regions.in_front_of(t) != m_regions.behind(t))
        for (const auto& [surface, times] : m_soup.shares[t])
          result[surface] |= times > 1;
    for_each_edge(sorted_sides(m_soup.triangles), [&](auto side, std::size_t number) {
      std::map<std::size_t, int> times_at_edge;
      for (const auto end = side + number; side != end; ++side)
        for (const auto& [surface, times] : m_soup.shares[side->triangle])
          times_at_edge[surface] += times;
      for (const auto& [surface, times] : times_at_edge)
        result[surface] |= times % 2 == 1;
    });
    return result;
  }

  // Returns the surfaces without walls around each region, in increasing order.
  std::vector<std::vector<std::size_t>>
  enclosing_surfaces(const std::vector<char>& has_walls) const {
    std::vector<std::vector<std::size_t>> result(m_regions.size());
    std::vector<std::size_t> crossed;
    m_regions.visit_regions([&](std::size_t t, bool to_back) {
      std::size_t from = m_regions.behind(t), to = m_regions.in_front_of(t);
      if (to_back)
        std::swap(from, to);
      crossed.clear();
      for (const auto& [surface, times] : m_soup.shares[t])
        if (!has_walls[surface])
          crossed.push_back(surface);
      std::set_symmetric_difference(result[from].begin(), result[from].end(), crossed.begin(),
                                    crossed.end(), std::back_inserter(result[to]));
    });
    return result;
  }

  // Adds a cell for each set of bounded regions that are not separated by a surface, in the order
  // of the first triangles.
  void add_cells_between_walls(std::size_t surface) {
    Disjoint_sets sets(m_regions.size());
    const auto is_of_surface = [&](std::size_t t) {
      const auto& shares = m_soup.shares[t];
      return std::any_of(shares.begin(), shares.end(),
                         [&](const auto& share) { return share.first == surface; });
    };
    for (std::size_t t = 0; t < m_soup.triangles.size(); ++t)
      if (!is_of_surface(t))
        sets.join(m_regions.in_front_of(t), m_regions.behind(t));
    std::map<std::size_t, std::size_t> cells; // by representatives
    for (std::size_t t = 0; t < m_soup.triangles.size(); ++t)
      if (is_of_surface(t))
        for (std::size_t r : {m_regions.in_front_of(t), m_regions.behind(t)})
          if (sets.find(r) != sets.find(Soup_regions_3::unbounded) &&
              cells.emplace(sets.find(r), m_surfaces.size()).second)
            m_surfaces.push_back(surface);
    for (std::size_t r = 0; r < m_regions.size(); ++r)
      if (const auto found = cells.find(sets.find(r)); found != cells.end())
        m_cells_of[r].push_back(found->second);
  }

  const Shared_soup_3& m_soup;
  Soup_regions_3 m_regions;
  std::vector<std::size_t> m_surfaces;
  std::vector<std::vector<std::size_t>> m_cells_of;
};

// Which cell covers the others in each region: the innermost one, and of several such cells the
// last one.
class Covering_cells_3
{
public:
  static constexpr std::size_t none = std::size_t(-1);

  explicit Covering_cells_3(const Solid_cells_3& cells) : m_sizes(cells.surfaces().size(), 0) {
    const std::size_t number_of_regions = cells.regions().size();
    for (std::size_t r = 0; r < number_of_regions; ++r) {
      const auto& of_region = cells.cells_of(r);
      for (std::size_t i = 0; i < of_region.size(); ++i) {
        ++m_sizes[of_region[i]];
        for (std::size_t j = 0; j < i; ++j)
          ++m_common[{of_region[j], of_region[i]}];
      }
    }
    for (std::size_t r = 0; r < number_of_regions; ++r)
      m_covering.push_back(covering(cells.cells_of(r)));
  }

  // Returns the cell that covers the others in a region, or `none` outside all cells.
  std::size_t in_region(std::size_t region) const { return m_covering[region]; }

  // Returns the pairs of cells that overlap, and do not contain each other unless they are equal.
  std::vector<std::array<std::size_t, 2>> overlaps() const {
    std::vector<std::array<std::size_t, 2>> result;
    for (const auto& [pair, common] : m_common)
      if (!contains(pair[0], pair[1]) && !contains(pair[1], pair[0]))
        result.push_back(pair);
    return result;
  }

private:
  // Returns whether a cell contains another one and is larger.
  bool contains(std::size_t larger, std::size_t smaller) const {
    return m_sizes[larger] > m_sizes[smaller] &&
           m_common.at({(std::min)(larger, smaller), (std::max)(larger, smaller)}) ==
               m_sizes[smaller];
  }

  std::size_t covering(const std::vector<std::size_t>& cells) const {
    for (auto c = cells.rbegin(); c != cells.rend(); ++c)
      if (std::none_of(cells.begin(), cells.end(),
                       [&](std::size_t other) { return other != *c && contains(*c, other); }))
        return *c;
    return none;
  }

  std::vector<std::size_t> m_sizes;                           // numbers of regions
  std::map<std::array<std::size_t, 2>, std::size_t> m_common; // numbers of common regions
  std::vector<std::size_t> m_covering;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_ARRANGEMENT_SOLID_CELLS_3_H
