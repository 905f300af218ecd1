// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_ASSEMBLE_TRIANGULATION_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_ASSEMBLE_TRIANGULATION_H

#include <CGAL/Deformable_simplicial_complex_3/exceptions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Vertex indices of a cell. In the arrays below, vertex 0 is infinite.
using Cell_vertices = std::array<std::size_t, 4>;

struct Cell_facet
{
  std::array<std::size_t, 3> vertices; // sorted
  std::size_t cell;
  int index;
  bool is_even; // the permutation (opposite vertex, sorted vertices) of the cell's vertices

  // Whether two cells of the same orientation lie on different sides of the facet they share.
  bool fits(const Cell_facet& other) const {
    return vertices == other.vertices && is_even != other.is_even;
  }
};

// All facets of the cells, equal ones next to each other, those of earlier cells first. A bucket
// for each smallest vertex leaves little to sort.
inline std::vector<Cell_facet> sorted_facets(const std::vector<Cell_vertices>& cells) {
  std::vector<Cell_facet> unsorted;
  unsorted.reserve(4 * cells.size());
  std::vector<std::size_t> bucket_ends;
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (int i = 0; i < 4; ++i) {
      std::array<std::size_t, 3> f = {cells[c][(i + 1) % 4], cells[c][(i + 2) % 4],
                                      cells[c][(i + 3) % 4]};
      const bool is_even = (i % 2 == 0) == ((f[0] < f[1]) == ((f[0] < f[2]) == (f[1] < f[2])));
      std::sort(f.begin(), f.end());
      unsorted.push_back({f, c, i, is_even});
      if (bucket_ends.size() < f[0] + 2)
        bucket_ends.resize(f[0] + 2, 0);
      ++bucket_ends[f[0] + 1];
    }
  std::partial_sum(bucket_ends.begin(), bucket_ends.end(), bucket_ends.begin());
  std::vector<Cell_facet> facets(unsorted.size());
  for (const Cell_facet& f : unsorted)
    facets[bucket_ends[f.vertices[0]]++] = f;
  for (auto first = facets.begin(); first != facets.end();) {
    const auto last = facets.begin() + bucket_ends[first->vertices[0]];
    std::sort(first, last, [](const Cell_facet& f, const Cell_facet& g) {
      return f.vertices[1] != g.vertices[1]   ? f.vertices[1] < g.vertices[1]
             : f.vertices[2] != g.vertices[2] ? f.vertices[2] < g.vertices[2]
                                              : f.cell < g.cell;
    });
    first = last;
  }
  return facets;
}

// Adds the infinite cells that close the boundary of finite, positively oriented ones. Throws
// Invalid_tetrahedra_error where cells are no neighbors on different sides of the facet they share.
inline void append_infinite_cells(std::vector<Cell_vertices>& cells) {
  const std::vector<Cell_facet> facets = sorted_facets(cells);
  for (std::size_t i = 0; i < facets.size();) {
    std::size_t j = i + 1;
    while (j < facets.size() && facets[j].vertices == facets[i].vertices)
      ++j;
    if (j - i > 2)
      throw Invalid_tetrahedra_error("more than two tetrahedra share a facet; give a mesh in which "
                                     "each facet has one or two",
                                     {facets[i].cell, facets[i + 1].cell, facets[i + 2].cell}, {});
    if (j - i == 2 && !facets[i].fits(facets[i + 1]))
      throw Invalid_tetrahedra_error("two tetrahedra overlap: remesh where they are",
                                     {facets[i].cell, facets[i + 1].cell});
    if (j - i == 1) {
      // Replacing the opposite vertex mirrors the cell: swapping two vertices turns it back.
      Cell_vertices infinite = cells[facets[i].cell];
      infinite[facets[i].index] = 0;
      std::swap(infinite[(facets[i].index + 1) % 4], infinite[(facets[i].index + 2) % 4]);
      cells.push_back(infinite);
    }
    i = j;
  }
}

// Makes an empty triangulation three-dimensional, without cells.
template <class Triangulation> void prepare_for_cells(Triangulation& triangulation) {
  triangulation.tds().delete_cell(triangulation.infinite_vertex()->cell());
  triangulation.tds().set_dimension(3);
}

// Fills an empty data structure with vertices and cells and makes the cells neighbors.
// `vertices[0]` exists already. Throws if a facet does not have exactly two cells, one on each
// side.
template <class Tds>
std::vector<typename Tds::Cell_handle>
create_cells(Tds& tds, const std::vector<typename Tds::Vertex_handle>& vertices,
             const std::vector<Cell_vertices>& cells) {
  std::vector<typename Tds::Cell_handle> handles;
  handles.reserve(cells.size());
  for (const Cell_vertices& c : cells) {
    handles.push_back(
        tds.create_cell(vertices[c[0]], vertices[c[1]], vertices[c[2]], vertices[c[3]]));
    for (std::size_t v : c)
      vertices[v]->set_cell(handles.back());
  }
  const std::vector<Cell_facet> facets = sorted_facets(cells);
  for (std::size_t i = 0; i < facets.size(); i += 2) {
    if (i + 1 == facets.size() || !facets[i].fits(facets[i + 1]) ||
        (i + 2 < facets.size() && facets[i].vertices == facets[i + 2].vertices))
      throw Invalid_tetrahedra_error(
          "the boundary of the tetrahedra is no closed 2-manifold; give a "
          "mesh whose domain is a ball",
          {facets[i].cell}, {facets[i].vertices.begin(), facets[i].vertices.end()});
    tds.set_adjacency(handles[facets[i].cell], facets[i].index, handles[facets[i + 1].cell],
                      facets[i + 1].index);
  }
  return handles;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_ASSEMBLE_TRIANGULATION_H
