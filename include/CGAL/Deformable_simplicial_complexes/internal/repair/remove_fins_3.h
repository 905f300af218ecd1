// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_REPAIR_REMOVE_FINS_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_REPAIR_REMOVE_FINS_3_H

#include <CGAL/Deformable_simplicial_complexes/Disjoint_sets.h>
#include <CGAL/Deformable_simplicial_complexes/internal/soups/Triangle_soup_3.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the triangles of a soup without its fins. A fin is a sheet of triangles connected through
// edges with exactly two triangles that has open edges and is attached to other triangles.
// \pre equal points are merged
inline std::vector<Triangle_indices> triangles_without_fins(const Triangle_soup_3& soup) {
  Disjoint_sets sheets(soup.triangles.size());
  const auto sides = sorted_sides(soup.triangles);
  const auto for_each_edge = [&sides](const auto& visit) {
    for (auto side = sides.cbegin(); side != sides.cend();) {
      const auto end = end_of_edge(side, sides.cend());
      visit(side, std::size_t(end - side));
      side = end;
    }
  };
  for_each_edge([&](auto side, std::size_t size) {
    if (size == 2)
      sheets.join(side[0].triangle, side[1].triangle);
  });
  std::vector<char> is_open(soup.triangles.size(), 0), is_attached(soup.triangles.size(), 0);
  for_each_edge([&](auto side, std::size_t size) {
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

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_REPAIR_REMOVE_FINS_3_H
