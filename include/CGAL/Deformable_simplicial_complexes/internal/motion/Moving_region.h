// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_MOVING_REGION_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_MOVING_REGION_H

#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Vertex_numbers.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/sort_by_time_stamp.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/star_union.h>
#include <CGAL/Mesh_support/For_each_index.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

/*
The finite cells around vertices that may move, and the vertices of these cells, as arrays. The
records of a triangulation are scattered in memory, so passes over the arrays are several times as
fast. Vertices have numbers: the movable ones come first, in their order, and the others follow.
Cells are sorted by time stamp, so sums over cells are deterministic. Valid until a vertex or cell
is created or removed.
*/
template <class Complex> class Moving_region
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  using Label = typename Complex::Label;
  using Number = std::uint32_t;
  using Corners = std::array<Number, Complex::corners>;
  static constexpr Number none = Vertex_numbers::none;

  // \pre The movable vertices are finite, and each is given once.
  Moving_region(const Complex& complex, const std::vector<Vertex_handle>& movable,
                const For_each_index& for_each_index)
      : m_complex(complex), m_cells(star_union(complex, movable, for_each_index)),
        m_vertices(movable), m_numbers(complex, movable) {
    sort_by_time_stamp(m_cells);
    m_corners.reserve(m_cells.size());
    m_labels.reserve(m_cells.size());
    for (Cell_handle c : m_cells) {
      m_labels.push_back(c->subdomain_index());
      m_corners.emplace_back();
      for (int i = 0; i < Complex::corners; ++i)
        m_corners.back()[i] = m_numbers.add(c->vertex(i), m_vertices);
    }
    m_positions.reserve(m_vertices.size());
    for (Vertex_handle v : m_vertices)
      m_positions.push_back(complex.position(v));
  }

  const Complex& complex() const { return m_complex; }

  // The cells, and the labels and corners of each.
  const std::vector<Cell_handle>& cells() const { return m_cells; }
  Label label(std::size_t cell) const { return m_labels[cell]; }
  const Corners& corners(std::size_t cell) const { return m_corners[cell]; }

  // The vertices by numbers, and their positions when the region was built.
  std::size_t size() const { return m_vertices.size(); }
  const std::vector<Vertex_handle>& vertices() const { return m_vertices; }
  const std::vector<typename Complex::Point>& positions() const { return m_positions; }

  // Returns the number of a vertex, or `none`.
  Number number(Vertex_handle v) const { return m_numbers(v); }

private:
  const Complex& m_complex;
  std::vector<Cell_handle> m_cells;
  std::vector<Label> m_labels;
  std::vector<Corners> m_corners;
  std::vector<Vertex_handle> m_vertices;
  std::vector<typename Complex::Point> m_positions;
  Vertex_numbers m_numbers;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_MOVING_REGION_H
