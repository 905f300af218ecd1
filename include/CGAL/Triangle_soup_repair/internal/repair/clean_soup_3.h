// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_REPAIR_CLEAN_SOUP_3_H
#define CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_REPAIR_CLEAN_SOUP_3_H

#include <CGAL/Mesh_support/internal/sets/Disjoint_sets.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Triangle_soup_3.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the triangles of a soup without its fins. A fin is a sheet of triangles connected through
// edges with exactly two triangles that has open edges and is attached to other triangles.
// \pre equal points are merged
inline std::vector<Triangle_indices> triangles_without_fins(const Triangle_soup_3& soup) {
  Disjoint_sets sheets(soup.triangles.size());
  const auto sides = sorted_sides(soup.triangles);
  for_each_edge(sides, [&](auto side, std::size_t size) {
    if (size == 2)
      sheets.join(side[0].triangle, side[1].triangle);
  });
  std::vector<char> is_open(soup.triangles.size(), 0), is_attached(soup.triangles.size(), 0);
  for_each_edge(sides, [&](auto side, std::size_t size) {
    if (size == 1)
      is_open[sheets.find(side->triangle)] = 1;
    for (std::size_t i = 0; size > 2 && i < size; ++i)
      is_attached[sheets.find(side[i].triangle)] = 1;
  });
  std::vector<Triangle_indices> result;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    if (!is_open[sheets.find(t)] || !is_attached[sheets.find(t)])
      result.push_back(soup.triangles[t]);
  return result;
}

// Removes the triangles that fulfill a condition. Returns their number.
template <class Condition>
std::size_t remove_triangles_if(Triangle_soup_3& soup, const Condition& condition) {
  auto& t = soup.triangles;
  const auto end = std::remove_if(t.begin(), t.end(), condition);
  const auto removed = std::size_t(t.end() - end);
  t.erase(end, t.end());
  return removed;
}

// Removes triangles in which a vertex occurs twice. Returns their number.
inline std::size_t remove_collapsed_triangles(Triangle_soup_3& soup) {
  return remove_triangles_if(soup, [](const Triangle_indices& t) { return !has_corners(t); });
}

// Removes repeated triangles: one of several triangles with the same vertices is kept. Sheets of
// triangles that occur an even number of times, such as walls between touching components, are
// removed completely if this reduces the number of edges with an odd number of triangles. Returns
// the number of removed triangles.
inline std::size_t remove_repeated_triangles(Triangle_soup_3& soup) {
  const std::size_t before = soup.triangles.size();
  std::map<Triangle_indices, std::vector<std::size_t>> groups;
  for (std::size_t t = 0; t < before; ++t)
    groups[sorted(soup.triangles[t])].push_back(t);
  std::vector<std::size_t> kept;
  for (const auto& [corners, group] : groups)
    kept.push_back(group.front());
  std::sort(kept.begin(), kept.end());
  std::vector<Triangle_indices> triangles;
  std::vector<char> is_even;
  for (std::size_t t : kept) {
    triangles.push_back(soup.triangles[t]);
    is_even.push_back(groups[sorted(soup.triangles[t])].size() % 2 == 0);
  }

  // The sheets: triangles that occur an even number of times and share edges.
  Disjoint_sets walls(triangles.size());
  const std::vector<Triangle_side> sides = sorted_sides(triangles);
  const auto for_each_wall_edge = [&](const auto& visit) {
    for_each_edge(sides, [&](auto side, std::size_t number) {
      std::vector<std::size_t> even;
      for (auto s = side; s != side + number; ++s)
        if (is_even[s->triangle])
          even.push_back(s->triangle);
      if (!even.empty())
        visit(even, number);
    });
  };
  for_each_wall_edge([&](const std::vector<std::size_t>& even, std::size_t) {
    for (std::size_t t : even)
      walls.join(t, even.front());
  });
  // of sheets: odd edges that become even without the sheet, less the reverse
  std::vector<std::ptrdiff_t> gain(triangles.size(), 0);
  for_each_wall_edge([&](const std::vector<std::size_t>& even, std::size_t number) {
    gain[walls.find(even.front())] +=
        std::ptrdiff_t(number % 2) - std::ptrdiff_t((number - even.size()) % 2);
  });
  soup.triangles.clear();
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (!is_even[t] || gain[walls.find(t)] <= 0)
      soup.triangles.push_back(triangles[t]);
  if (soup.triangles.empty()) // the soup is a single sheet with two sides
    soup.triangles = triangles;
  return before - soup.triangles.size();
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_REPAIR_CLEAN_SOUP_3_H
