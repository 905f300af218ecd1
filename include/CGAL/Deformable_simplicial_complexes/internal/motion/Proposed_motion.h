// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_PROPOSED_MOTION_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_PROPOSED_MOTION_H

#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Vertex_numbers.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/star_union.h>
#include <CGAL/Mesh_support/For_each_index.h>

#include <CGAL/enum.h>

#include <limits>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Proposed points for a list of vertices, and the validity and quality of the complex with these
// points. Vertices are identified by their index in the list.
template <class Complex> class Proposed_motion
{
public:
  using Cell_handle = typename Complex::Cell_handle;
  using Vertex_handle = typename Complex::Vertex_handle;
  using Point = typename Complex::Point;
  using Number = std::uint32_t;

  // `cells` are the finite cells around the vertices, each once.
  Proposed_motion(Complex& complex, const std::vector<Vertex_handle>& vertices,
                  const std::vector<Point>& points, const std::vector<Cell_handle>& cells,
                  const For_each_index& for_each_index)
      : m_complex(complex), m_for_each_index(for_each_index), m_vertices(vertices),
        m_points(points), m_are_changed(points.size()), m_numbers(complex, vertices),
        m_cells(cells) {}

  const Complex& complex() const { return m_complex; }
  std::size_t size() const { return m_vertices.size(); }
  Vertex_handle vertex(Number i) const { return m_vertices[i]; }
  const Point& point(Number i) const { return m_points[i]; }
  void set_point(Number i, const Point& p) {
    m_points[i] = m_complex.canonical(p);
    m_are_changed[i] = m_is_changed = true;
  }

  bool has(Vertex_handle v) const { return m_numbers.has(v); }
  Number number(Vertex_handle v) const { return m_numbers(v); }

  // Returns the finite cells around all vertices.
  const std::vector<Cell_handle>& cells() const { return m_cells; }

  // Returns the proposed position of a vertex of the list, or the current position of any other
  // vertex.
  const Point& position(Vertex_handle v) const {
    const Number i = number(v);
    return i != Vertex_numbers::none ? m_points[i] : v->point();
  }

  // Returns the cells that would not be positively oriented. Also stores the current measures and
  // the proposed qualities of all cells, so that each cell is visited once.
  std::vector<Cell_handle> inverted_cells() {
    std::vector<char> is_inverted(m_cells.size());
    m_measures.resize(m_cells.size());
    m_qualities.resize(m_cells.size());
    m_is_degraded.resize(m_cells.size());
    m_for_each_index(m_cells.size(), [&](std::size_t i) {
      is_inverted[i] = !is_positive(m_cells[i]);
      m_measures[i] = m_complex.measure(m_cells[i]);
      if (!is_inverted[i])
        store_quality(i);
    });
    std::fill(m_are_changed.begin(), m_are_changed.end(), false);
    m_is_changed = false;
    return chosen(m_cells, is_inverted);
  }

  // Returns the cells whose quality would fall below the floor.
  // \pre inverted_cells() was called, and all cells would now be positively oriented
  std::vector<Cell_handle> degraded_cells() {
    if (m_is_changed)
      m_for_each_index(m_cells.size(), [&](std::size_t i) {
        if (is_changed(m_cells[i]))
          store_quality(i);
      });
    std::fill(m_are_changed.begin(), m_are_changed.end(), false);
    m_is_changed = false;
    return chosen(m_cells, m_is_degraded);
  }

  // Returns those of the given cells that would not be positively oriented, or whose quality would
  // fall below the floor.
  std::vector<Cell_handle> bad_cells(const std::vector<Cell_handle>& cells) const {
    std::vector<char> is_bad(cells.size());
    m_for_each_index(cells.size(), [&](std::size_t i) {
      is_bad[i] = !(is_positive(cells[i]) &&
                    Complex::keeps_quality(cells[i]->quality(), quality(cells[i])));
    });
    return chosen(cells, is_bad);
  }

  // Returns the finite cells around vertices, each once.
  std::vector<Cell_handle> stars(std::vector<Number> numbers) const {
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    std::vector<Vertex_handle> vertices;
    for (Number i : numbers)
      vertices.push_back(m_vertices[i]);
    return stars_of(m_complex, vertices);
  }

  // Returns the moving vertices of cells for which a condition on the number holds, in increasing
  // order.
  template <class Condition>
  std::vector<Number> vertices_of(const std::vector<Cell_handle>& cells,
                                  const Condition& condition) const {
    std::vector<Number> result;
    for (Cell_handle c : cells)
      for (int i = 0; i < Complex::corners; ++i)
        if (has(c->vertex(i)) && condition(number(c->vertex(i))))
          result.push_back(number(c->vertex(i)));
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // Returns the worst quality of the cells after the motion, or `bound` if a quality is not above
  // it.
  double worst_quality(const std::vector<Cell_handle>& cells, double bound) const {
    double worst = std::numeric_limits<double>::infinity();
    for (Cell_handle c : cells) {
      const double after = quality(c);
      if (!(after > bound)) // or is not a number
        return bound;
      worst = (std::min)(worst, after);
    }
    return worst;
  }

  // Moves the vertices to the proposed points.
  // \pre inverted_cells() is empty, and degraded_cells() was called since the last change
  void commit() {
    m_complex.set_points(m_vertices, m_points, m_cells, m_measures, m_qualities, m_for_each_index);
  }

private:
  static std::vector<Cell_handle> chosen(const std::vector<Cell_handle>& cells,
                                         const std::vector<char>& are_chosen) {
    std::vector<Cell_handle> result;
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (are_chosen[i])
        result.push_back(cells[i]);
    return result;
  }

  void store_quality(std::size_t i) {
    m_qualities[i] = quality(m_cells[i]);
    m_is_degraded[i] = !Complex::keeps_quality(m_cells[i]->quality(), m_qualities[i]);
  }

  double quality(Cell_handle c) const {
    return m_complex.quality(c, [&](Vertex_handle v) -> const Point& { return position(v); });
  }

  bool is_positive(Cell_handle c) const {
    return m_complex.is_positive(c, [&](Vertex_handle v) -> const Point& { return position(v); });
  }

  // Returns whether a vertex of the cell has a new point since the qualities were computed.
  bool is_changed(Cell_handle c) const {
    for (int i = 0; i < Complex::corners; ++i)
      if (has(c->vertex(i)) && m_are_changed[number(c->vertex(i))])
        return true;
    return false;
  }

  Complex& m_complex;
  const For_each_index& m_for_each_index;
  const std::vector<Vertex_handle>& m_vertices;
  std::vector<Point> m_points;
  std::vector<char> m_are_changed; // points that changed since the qualities were computed
  bool m_is_changed = false;       // whether any point changed since then
  Vertex_numbers m_numbers;
  const std::vector<Cell_handle>& m_cells;
  std::vector<double> m_measures;  // current measures of the cells
  std::vector<double> m_qualities; // qualities of the cells after the motion
  std::vector<char> m_is_degraded; // cells whose quality would fall below the floor
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_PROPOSED_MOTION_H
