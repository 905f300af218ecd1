// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_ASSEMBLE_TRIANGULATION_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_ASSEMBLE_TRIANGULATION_H

#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Item_numbers.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <numeric>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The vertex indices of a cell. In the arrays of this file, vertex 0 is the infinite vertex.
template <int d> using Cell_vertices = std::array<std::size_t, d + 1>;

template <int d> struct Cell_facet
{
  std::array<std::size_t, d> vertices; // sorted
  std::size_t cell;
  int index;
  // parity of the permutation (opposite vertex, sorted vertices) of the vertices of the cell
  bool is_even;

  // Returns whether two cells with the same orientation lie on different sides of a common facet.
  bool fits(const Cell_facet& other) const {
    return vertices == other.vertices && is_even != other.is_even;
  }
};

// Sorts the vertices of a simplex. Returns whether the permutation is even.
template <class Number, std::size_t n> bool sort_vertices(std::array<Number, n>& vertices) {
  bool is_even = true;
  for (std::size_t i = 1; i < n; ++i)
    for (std::size_t j = i; j > 0 && vertices[j] < vertices[j - 1]; --j) {
      std::swap(vertices[j], vertices[j - 1]);
      is_even = !is_even;
    }
  return is_even;
}

// Returns all facets of the cells. Equal facets are adjacent, ordered by cell. Facets are first put
// into buckets by their smallest vertex, so that each sort is short.
template <std::size_t corners>
std::vector<Cell_facet<int(corners) - 1>>
sorted_facets(const std::vector<std::array<std::size_t, corners>>& cells) {
  static constexpr int d = int(corners) - 1;
  using Facet = Cell_facet<d>;
  const auto for_each_facet = [&](const auto& visit) {
    for (std::size_t c = 0; c < cells.size(); ++c) {
      Progress_scope::check();
      for (int i = 0; i <= d; ++i) {
        std::array<std::size_t, d> f;
        for (int k = 0; k < d; ++k)
          f[k] = cells[c][k < i ? k : k + 1];
        // The vertex i is moved to the front by i exchanges.
        const bool is_even = sort_vertices(f) == (i % 2 == 0);
        visit(Facet{f, c, i, is_even});
      }
    }
  };
  std::vector<std::size_t> bucket_ends;
  for_each_facet([&](const Facet& f) {
    if (bucket_ends.size() < f.vertices[0] + 2)
      bucket_ends.resize(f.vertices[0] + 2, 0);
    ++bucket_ends[f.vertices[0] + 1];
  });
  std::partial_sum(bucket_ends.begin(), bucket_ends.end(), bucket_ends.begin());
  std::vector<Facet> facets(corners * cells.size());
  for_each_facet([&](const Facet& f) { facets[bucket_ends[f.vertices[0]]++] = f; });
  for (auto first = facets.begin(); first != facets.end();) {
    Progress_scope::check();
    const auto last = facets.begin() + bucket_ends[first->vertices[0]];
    std::sort(first, last, [](const Facet& f, const Facet& g) {
      return f.vertices != g.vertices ? f.vertices < g.vertices : f.cell < g.cell;
    });
    first = last;
  }
  return facets;
}

// Adds the infinite cells at the boundary of the finite cells.
// \pre The finite cells are positively oriented.
//
// Throws `Invalid_cells_error` if a facet has more than two cells, or if two cells lie on the same
// side of a common facet.
template <std::size_t corners>
void append_infinite_cells(std::vector<std::array<std::size_t, corners>>& cells) {
  const auto facets = sorted_facets(cells);
  for (std::size_t i = 0; i < facets.size();) {
    Progress_scope::check();
    std::size_t j = i + 1;
    while (j < facets.size() && facets[j].vertices == facets[i].vertices)
      ++j;
    if (j - i > 2)
      throw Invalid_cells_error("more than two cells share a facet; give a mesh in which each "
                                "facet has one or two cells",
                                {facets[i].cell, facets[i + 1].cell, facets[i + 2].cell}, {});
    if (j - i == 2 && !facets[i].fits(facets[i + 1]))
      throw Invalid_cells_error("two cells overlap: remesh near these cells",
                                {facets[i].cell, facets[i + 1].cell});
    if (j - i == 1) {
      // Replacing the opposite vertex inverts the orientation; swapping two vertices restores it.
      auto infinite = cells[facets[i].cell];
      infinite[facets[i].index] = 0;
      std::swap(infinite[(facets[i].index + 1) % corners],
                infinite[(facets[i].index + 2) % corners]);
      cells.push_back(infinite);
    }
    i = j;
  }
}

// Sets the dimension of an empty triangulation to the full dimension, without cells.
template <class Space> void prepare_for_cells(typename Space::Triangulation& triangulation) {
  Space::delete_cell(triangulation.tds(), triangulation.infinite_vertex()->cell());
  triangulation.tds().set_dimension(Space::dimension);
}

// Creates cells between given vertices, without their adjacency. `vertices[0]` is the infinite
// vertex.
template <class Space>
std::vector<typename Space::Cell_handle> create_unsewn_cells(
    typename Space::Triangulation_data_structure& tds,
    Item_numbers<typename Space::Vertex_handle, typename Space::Cell_handle>& numbers,
    const std::vector<typename Space::Vertex_handle>& vertices,
    const std::vector<Cell_vertices<Space::dimension>>& cells) {
  std::vector<typename Space::Cell_handle> handles;
  handles.reserve(cells.size());
  for (const auto& c : cells) {
    Progress_scope::check();
    handles.push_back(numbers.add_cell(Space::create_cell(tds)));
    for (int i = 0; i <= Space::dimension; ++i) {
      handles.back()->set_vertex(i, vertices[c[i]]);
      vertices[c[i]]->set_cell(handles.back());
    }
  }
  return handles;
}

// Sets the adjacency of cells at their facets, from the sorted facet `first` on. Throws
// `Invalid_cells_error` unless each facet has exactly two cells, one on each side.
template <class Space, class Facets>
void sew_facets(typename Space::Triangulation_data_structure& tds,
                const std::vector<typename Space::Cell_handle>& handles, const Facets& facets,
                std::size_t first = 0) {
  for (std::size_t i = first; i < facets.size(); i += 2) {
    Progress_scope::check();
    if (i + 1 == facets.size() || !facets[i].fits(facets[i + 1]) ||
        (i + 2 < facets.size() && facets[i].vertices == facets[i + 2].vertices))
      throw Invalid_cells_error("the boundary of the cells is not a closed manifold; give a "
                                "mesh whose domain is a ball, in the plane a disk",
                                {facets[i].cell},
                                {facets[i].vertices.begin(), facets[i].vertices.end()});
    tds.set_adjacency(handles[facets[i].cell], facets[i].index, handles[facets[i + 1].cell],
                      facets[i + 1].index);
  }
}

// Creates cells between given vertices in an empty data structure, and sets their adjacency.
// `vertices[0]` is the existing infinite vertex. Throws `Invalid_cells_error` unless each facet has
// exactly two cells, one on each side.
template <class Space>
std::vector<typename Space::Cell_handle>
create_cells(typename Space::Triangulation_data_structure& tds,
             Item_numbers<typename Space::Vertex_handle, typename Space::Cell_handle>& numbers,
             const std::vector<typename Space::Vertex_handle>& vertices,
             const std::vector<Cell_vertices<Space::dimension>>& cells) {
  auto handles = create_unsewn_cells<Space>(tds, numbers, vertices, cells);
  sew_facets<Space>(tds, handles, sorted_facets(cells));
  return handles;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_ASSEMBLE_TRIANGULATION_H
