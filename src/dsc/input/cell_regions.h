// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_CELL_REGIONS_H
#define DSC_CELL_REGIONS_H

#include "programs/errors.h"

#include <CGAL/Mesh_support/Progress_scope.h>

#include <algorithm>
#include <array>
#include <vector>

namespace dsc {

/// The sets of finite cells that are connected through facets other than barriers.
template <class Complex> struct Cell_regions
{
  using Cell_handle = typename Complex::Cell_handle;

  /// \param is_barrier `bool is_barrier(Cell_handle c, int i)` tells whether the facet opposite to
  /// vertex i of c is a barrier
  template <class Is_barrier> Cell_regions(const Complex& complex, const Is_barrier& is_barrier) {
    constexpr int none = -1;
    of_cell.assign(complex.cell_id_bound(), none);
    std::vector<Cell_handle> open;
    for (const Cell_handle first : complex.cells()) {
      if (of_cell[first->id()] != none)
        continue;
      open.push_back(first);
      of_cell[first->id()] = number;
      while (!open.empty()) {
        DSC::Progress_scope::check();
        const Cell_handle c = open.back();
        open.pop_back();
        for (int i = 0; i < 4; ++i) {
          const Cell_handle n = c->neighbor(i);
          if (complex.is_infinite(n) || of_cell[n->id()] != none || is_barrier(c, i))
            continue;
          of_cell[n->id()] = number;
          open.push_back(n);
        }
      }
      ++number;
    }
  }

  std::vector<int> of_cell; ///< region of each cell, indexed by the id of the cell
  int number = 0;           ///< number of regions
};

/// Returns the cells, including infinite ones, that contain all given vertices; none if the
/// vertices are not those of a simplex.
template <class Complex, std::size_t n>
std::vector<typename Complex::Cell_handle>
cells_around(const Complex& complex,
             const std::array<typename Complex::Vertex_handle, n>& vertices) {
  std::vector<typename Complex::Cell_handle> result;
  complex.star(vertices.front(), result);
  const auto lacks_one = [&](typename Complex::Cell_handle c) {
    return !std::all_of(vertices.begin(), vertices.end(), [&](auto v) { return c->has_vertex(v); });
  };
  result.erase(std::remove_if(result.begin(), result.end(), lacks_one), result.end());
  return result;
}

/// Returns the handles of the vertices of a simplex.
template <class Vertex_handle, std::size_t n>
std::array<Vertex_handle, n> handles(const std::vector<Vertex_handle>& all,
                                     const std::array<std::size_t, n>& indices) {
  std::array<Vertex_handle, n> result;
  for (std::size_t i = 0; i < n; ++i)
    result[i] = all[indices[i]];
  return result;
}

} // namespace dsc

#endif // DSC_CELL_REGIONS_H
