// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_INTERNAL_GRIDS_WRITTEN_VERTICES_H
#define CGAL_MESH_FILES_INTERNAL_GRIDS_WRITTEN_VERTICES_H

#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Vertex_numbers.h>

#include <numeric>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Numbers the vertices of a complex as they are written, by increasing time stamp. Where a domain
// touches itself, the complex has several vertices at the same position, see `Solid_domain`. They
// are written as one.
template <class Complex> class Written_vertices
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;

  explicit Written_vertices(const Complex& complex) : m_all(complex) {
    std::vector<Vertex_handle> all;
    for (const Vertex_handle v : complex.vertices())
      m_all.add(v, all);
    m_numbers.resize(all.size());
    std::iota(m_numbers.begin(), m_numbers.end(),
              std::size_t(0)); // first vertices at the positions
    if constexpr (Complex::Domain::has_outside && !Complex::Domain::is_ball) {
      auto order = m_numbers;
      std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
        return complex.position(all[i]) < complex.position(all[j]);
      });
      for (std::size_t k = 1; k < order.size(); ++k)
        if (complex.position(all[order[k - 1]]) == complex.position(all[order[k]]))
          m_numbers[order[k]] = m_numbers[order[k - 1]];
    }
    for (std::size_t i = 0; i < all.size(); ++i)
      if (m_numbers[i] == i) {
        m_numbers[i] = m_vertices.size();
        m_vertices.push_back(all[i]);
      } else {
        m_numbers[i] = m_numbers[m_numbers[i]];
      }
  }

  // Returns the vertices, without copies.
  const std::vector<Vertex_handle>& vertices() const { return m_vertices; }

  // Returns the number of a vertex or of a copy of it.
  std::size_t operator()(Vertex_handle v) const { return m_numbers[m_all(v)]; }

private:
  Vertex_numbers m_all;
  std::vector<std::size_t> m_numbers; // of all vertices
  std::vector<Vertex_handle> m_vertices;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_FILES_INTERNAL_GRIDS_WRITTEN_VERTICES_H
