// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_COMPLEX_BUILDER_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_COMPLEX_BUILDER_H

#include <CGAL/Deformable_simplicial_complexes/internal/complex/assemble_triangulation.h>

#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

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

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_COMPLEX_BUILDER_H
