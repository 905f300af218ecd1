// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PARTS_ASSIGN_PART_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PARTS_ASSIGN_PART_H

#include <CGAL/Deformable_simplicial_complexes/internal/complex/assemble_triangulation.h>
#include <CGAL/Mesh_support/coordinates.h>
#include <CGAL/Mesh_support/internal/sets/Disjoint_sets.h>

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

// Assembles an empty complex from the vertices and cells of a state, without the checks of
// `Labeled_complex::restore()`. The caller sews the cells and calls finish().
template <class Complex> class Complex_builder
{
public:
  using Space = typename Complex::Space;
  using State = typename Complex::State;
  using Vertex_handle = typename Complex::Vertex_handle;

  // `complex` must be empty.
  Complex_builder(Complex& complex, const State& state) : m_complex(complex), m_state(state) {}

  // Creates the vertices. Returns the infinite vertex, followed by them.
  std::vector<Vertex_handle> create_vertices() { return m_complex.create_vertices(m_state); }

  // Returns the vertices of the cells, as indices. 0 is the infinite vertex.
  auto cell_vertices() const { return m_complex.indices_of(m_state); }

  // Creates cells that are not adjacent to each other.
  std::vector<typename Complex::Cell_handle>
  create_unsewn_cells(const std::vector<Vertex_handle>& vertices,
                      const std::vector<Cell_vertices<Complex::dimension>>& cells) {
    return internal::create_unsewn_cells<Space>(tds(), m_complex.m_numbers, vertices, cells);
  }

  typename Space::Triangulation_data_structure& tds() { return m_complex.m_triangulation.tds(); }

  // Computes all data that follows from points, cells and labels, and takes the lengths of the
  // interface from the state.
  void finish() {
    m_complex.m_mean_interface_edge = m_state.mean_interface_edge;
    m_complex.m_minimum_interface_edge = m_state.minimum_interface_edge;
    m_complex.initialize_caches();
  }

private:
  Complex& m_complex;
  const State& m_state;
};

// Makes the infinite cells of a part adjacent across the ridges of its boundary: edges in 3D,
// vertices in 2D. Two infinite cells at a ridge are adjacent if finite cells lie between them.
template <class Space>
void join_infinite_cells(typename Space::Triangulation_data_structure& tds,
                         typename Space::Vertex_handle infinite,
                         const std::vector<typename Space::Cell_handle>& cells) {
  using Cell_handle = typename Space::Cell_handle;
  for (Cell_handle c : cells) {
    int outside = 0;
    const bool is_infinite = c->has_vertex(infinite, outside);
    for (int i = 0; is_infinite && i <= Space::dimension; ++i) {
      if (i == outside)
        continue;
      Cell_handle previous = c, next = c->neighbor(outside);
      auto left = c->vertex(i); // vertex of the facet through which the turn entered `next`
      while (!next->has_vertex(infinite)) {
        const auto apex = next->vertex(next->index(previous));
        previous = next;
        next = next->neighbor(next->index(left));
        left = apex;
      }
      tds.set_adjacency(c, i, next, next->index(left));
    }
  }
}

// Replaces a complex by given cells, such as a part of another complex. Time stamps follow the
// order of vertices and cells. n log n in the number of cells. Returns the vertices, in their
// order.
// \param state points, boundary classes and spacings of the vertices; vertices, labels, noted
//        qualities and failures of the finite cells, where `i + 1` is the vertex `i`; lengths and
//        normalization. Other members are not used.
// \throws Invalid_cells_error if more than two cells share a facet, or two cells overlap; the complex
//         is then unchanged
// \pre Each vertex has a cell. The cells are positively oriented. The cells around a vertex are
//      connected through facets.
template <class Part>
std::vector<typename Part::Vertex_handle> assign_part(Part& part,
                                                      const typename Part::State& state) {
  using Space = typename Part::Space;
  static_assert(!Part::Domain::is_ball && Part::Domain::has_outside);
  Part result(part.geom_traits(), part.quality_measure(), part.domain());
  result.set_normalization(
      {vector_of<Part>(state.normalization_translation), state.normalization_scale});
  Complex_builder<Part> builder(result, state);
  const auto vertices = builder.create_vertices();
  auto cell_vertices = builder.cell_vertices();
  append_infinite_cells(cell_vertices);
  const auto cells = builder.create_unsewn_cells(vertices, cell_vertices);
  // Facets of infinite cells, which come first, may have more than two cells.
  const auto facets = sorted_facets(cell_vertices);
  std::size_t first = 0;
  while (first < facets.size() && facets[first].vertices[0] == 0)
    ++first;
  sew_facets<Space>(builder.tds(), cells, facets, first);
  join_infinite_cells<Space>(builder.tds(), vertices[0], cells);
  for (std::size_t i = 0; i < state.cells.size(); ++i) {
    cells[i]->set_subdomain_index(state.cell_labels[i]);
    Simplex_access::set_failures(cells[i], state.failures[i]);
    Simplex_access::set_noted_quality(cells[i], state.noted_qualities[i]);
  }
  builder.finish();
  part = std::move(result);
  return {vertices.begin() + 1, vertices.end()};
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PARTS_ASSIGN_PART_H
