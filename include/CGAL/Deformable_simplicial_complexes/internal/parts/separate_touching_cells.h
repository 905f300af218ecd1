// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PARTS_SEPARATE_TOUCHING_CELLS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PARTS_SEPARATE_TOUCHING_CELLS_H

#include <CGAL/Deformable_simplicial_complexes/internal/complex/assemble_triangulation.h>
#include <CGAL/Mesh_support/internal/sets/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Duplicates vertices at which the boundary of the cells is non-manifold. The cells around a vertex
// form sets that are connected through facets; each set except the first one gets a copy of the
// vertex. The vertices of the cells are replaced. Returns the original of each vertex; the first
// ones are the original vertices themselves.
template <std::size_t corners>
std::vector<std::size_t>
separate_touching_cells(std::size_t number_of_vertices,
                        std::vector<std::array<std::size_t, corners>>& cells) {
  Disjoint_sets sets(corners * cells.size()); // of the corners of the cells
  const auto corner = [&](std::size_t c, std::size_t vertex) {
    return corners * c + (std::find(cells[c].begin(), cells[c].end(), vertex) - cells[c].begin());
  };
  const auto facets = sorted_facets(cells);
  for (std::size_t i = 0; i + 1 < facets.size(); ++i)
    if (facets[i].vertices == facets[i + 1].vertices)
      for (std::size_t v : facets[i].vertices)
        sets.join(corner(facets[i].cell, v), corner(facets[i + 1].cell, v));
  std::vector<std::size_t> originals(number_of_vertices), number_of_set(corners * cells.size(), 0);
  std::iota(originals.begin(), originals.end(), 0);
  std::vector<bool> is_taken(number_of_vertices, false);
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (std::size_t i = 0; i < corners; ++i) {
      std::size_t& number = number_of_set[sets.find(corners * c + i)]; // plus 1
      const std::size_t v = cells[c][i];
      if (number == 0 && !is_taken[v]) {
        is_taken[v] = true;
        number = v + 1;
      } else if (number == 0) {
        originals.push_back(v);
        number = originals.size();
      }
      cells[c][i] = number - 1;
    }
  return originals;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PARTS_SEPARATE_TOUCHING_CELLS_H
