// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_PROPOSED_MOTION_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_PROPOSED_MOTION_H

#include <CGAL/Deformable_simplicial_complexes/internal/motion/Moving_region.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/star_union.h>
#include <CGAL/Mesh_support/For_each_index.h>

#include <CGAL/enum.h>

#include <limits>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Proposed points for the movable vertices of a region, and the validity and quality of the complex
// with these points. Vertices are identified by their numbers. Those whose first point is their
// position do not take part.
template <class Complex> class Proposed_motion
{
public:
  using Cell_handle = typename Complex::Cell_handle;
  using Vertex_handle = typename Complex::Vertex_handle;
  using Point = typename Complex::Point;
  using Region = Moving_region<Complex>;
  using Number = typename Region::Number;

  // `points` are the points of the movable vertices.
  Proposed_motion(Complex& complex, const Region& region, const std::vector<Point>& points,
                  const For_each_index& for_each_index)
      : m_complex(complex), m_for_each_index(for_each_index), m_region(region),
        m_points(region.positions()), m_are_moving(region.size(), false),
        m_are_changed(region.size(), false) {
    for (Number i = 0; i < points.size(); ++i)
      if (points[i] != m_points[i]) {
        m_points[i] = points[i];
        m_are_moving[i] = true;
        m_moving.push_back(i);
      }
    for (Number c = 0; c < region.cells().size(); ++c)
      if (has_any(c, m_are_moving)) {
        m_places.push_back(c);
        m_cells.push_back(region.cells()[c]);
      }
    m_measures.resize(m_cells.size());
    m_qualities.resize(m_cells.size());
    m_are_degraded.resize(m_cells.size());
  }

  const Complex& complex() const { return m_complex; }
  const std::vector<Number>& moving() const { return m_moving; } // the vertices that take part
  Vertex_handle vertex(Number i) const { return m_region.vertices()[i]; }
  const Point& point(Number i) const { return m_points[i]; }
  const std::vector<Point>& points() const { return m_points; } // by number
  void set_point(Number i, const Point& p) {
    m_points[i] = m_complex.canonical(p);
    m_are_changed[i] = m_is_changed = true;
  }

  bool has(Vertex_handle v) const { return number(v) != Region::none && m_are_moving[number(v)]; }
  Number number(Vertex_handle v) const { return m_region.number(v); }

  // Returns the finite cells around the vertices that take part, by increasing time stamp.
  const std::vector<Cell_handle>& cells() const { return m_cells; }

  // Returns the proposed position of a vertex that takes part, or the current position of any other
  // vertex.
  const Point& position(Vertex_handle v) const {
    const Number i = number(v);
    return i != Region::none ? m_points[i] : v->point();
  }

  // Returns the cells that would not be positively oriented. Also stores the measures and qualities
  // of all cells, so that each cell is visited once.
  std::vector<Cell_handle> inverted_cells() {
    std::vector<char> are_inverted(m_cells.size());
    m_for_each_index(m_cells.size(), [&](std::size_t i) {
      const auto now = corners(i, m_region.positions()), then = corners(i, m_points);
      are_inverted[i] = m_complex.domain().orientation(m_complex, then) != POSITIVE;
      m_measures[i][0] = measure(now);
      if (!are_inverted[i])
        store_shape(i);
    });
    std::fill(m_are_changed.begin(), m_are_changed.end(), false);
    m_is_changed = false;
    return chosen(m_cells, are_inverted);
  }

  // Returns the cells whose quality would fall below the floor.
  // \pre inverted_cells() was called, and all cells would now be positively oriented
  std::vector<Cell_handle> degraded_cells() {
    if (m_is_changed)
      m_for_each_index(m_cells.size(), [&](std::size_t i) {
        if (has_any(m_places[i], m_are_changed))
          store_shape(i);
      });
    std::fill(m_are_changed.begin(), m_are_changed.end(), false);
    m_is_changed = false;
    return chosen(m_cells, m_are_degraded);
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
      vertices.push_back(vertex(i));
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
    std::vector<Vertex_handle> vertices;
    std::vector<Point> points;
    for (Number i : m_moving) {
      vertices.push_back(vertex(i));
      points.push_back(m_points[i]);
    }
    m_complex.set_points(vertices, points, m_cells, m_measures, m_qualities, m_for_each_index);
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

  // Returns a function that returns the corners of a cell with the vertices at given points.
  auto corners(std::size_t i, const std::vector<Point>& points) const {
    return [&numbers = m_region.corners(m_places[i]), &points](int k) -> const Point& {
      return points[numbers[k]];
    };
  }

  template <class Corners> double measure(const Corners& corners) const {
    return m_complex.domain().template apply<Complex>(Complex::Space::measure, corners);
  }

  // Stores the measure and the quality of a cell with the proposed points.
  void store_shape(std::size_t i) {
    const auto then = corners(i, m_points);
    m_measures[i][1] = measure(then);
    m_qualities[i] = m_complex.domain().template apply<Complex>(m_complex.quality_measure(), then);
    m_are_degraded[i] = !Complex::keeps_quality(m_cells[i]->quality(), m_qualities[i]);
  }

  double quality(Cell_handle c) const {
    return m_complex.quality(c, [&](Vertex_handle v) -> const Point& { return position(v); });
  }

  bool is_positive(Cell_handle c) const {
    return m_complex.is_positive(c, [&](Vertex_handle v) -> const Point& { return position(v); });
  }

  // Returns whether a corner of a cell of the region is marked.
  bool has_any(Number cell, const std::vector<char>& marks) const {
    const auto& corners = m_region.corners(cell);
    return std::any_of(corners.begin(), corners.end(), [&](Number v) { return marks[v]; });
  }

  Complex& m_complex;
  const For_each_index& m_for_each_index;
  const Region& m_region;
  std::vector<Point> m_points; // by number
  std::vector<char> m_are_moving;
  std::vector<Number> m_moving;
  std::vector<char> m_are_changed; // points that changed since the qualities were computed
  bool m_is_changed = false;       // whether any point changed since then
  std::vector<Number> m_places;    // of the cells in the region
  std::vector<Cell_handle> m_cells;
  std::vector<std::array<double, 2>> m_measures; // of the cells before and after the motion
  std::vector<double> m_qualities;               // of the cells after the motion
  std::vector<char> m_are_degraded;              // cells whose quality would fall below the floor
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_PROPOSED_MOTION_H
