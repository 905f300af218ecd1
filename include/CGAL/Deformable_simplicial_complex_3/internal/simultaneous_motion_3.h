// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_SIMULTANEOUS_MOTION_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_SIMULTANEOUS_MOTION_3_H

#include <CGAL/Deformable_simplicial_complex_3/internal/For_each_index.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/star_union.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

/*
Moves vertices towards their targets all at once, as far as no cell inverts. Where a cell would, its
moving vertices are held back: each goes half of its way, then a quarter, and so on. So that a vertex
held back does not shear the cells around it, its neighbors get ahead of it by a part of the edge between
them at the most, theirs again, and so on; farther away nothing is held back.

With every cell positive and the boundary of the domain in place, the map from the old to the new complex
is a homeomorphism: nothing was passed through on the way.
*/
template <class Complex> class Simultaneous_motion_3
{
public:
  using Cell_handle = typename Complex::Cell_handle;
  using Vertex_handle = typename Complex::Vertex_handle;
  using Point_3 = typename Complex::Point_3;
  using Vector = typename Complex::Approximate_vector_3;

  Simultaneous_motion_3(Complex& complex, const std::vector<Vertex_handle>& vertices,
                        const std::vector<Point_3>& targets,
                        const For_each_index& for_each_index)
      : m_complex(complex), m_for_each_index(for_each_index), m_vertices(vertices), m_targets(targets), m_proposal(targets),
        m_way(vertices.size(), 1.)
  {
    number_vertices(vertices);
    m_cells = star_union(complex, vertices);
  }

  // Returns the cells around the vertices. The rounds end because in each a
  // vertex is held back further, and cells whose vertices all stay are positive.
  const std::vector<Cell_handle>& run()
  {
    std::vector<Cell_handle> unchecked = m_cells, star;
    while (!unchecked.empty()) {
      const std::vector<std::uint32_t> held = hold_back(unchecked);
      unchecked.clear();
      for (std::uint32_t i : held) {
        m_complex.star(m_vertices[i], star);
        for (Cell_handle c : star)
          if (!m_complex.is_infinite(c))
            unchecked.push_back(c);
      }
    }
    m_complex.set_points(m_vertices, m_proposal, m_cells, m_for_each_index);
    return m_cells;
  }

private:
  static constexpr double shortest_way = 1. / 16; // below, a vertex stays
  static constexpr double lead = .25;             // of an edge, by which one end may get ahead

  bool is_positive(Cell_handle c) const
  {
    const auto point = [&](int i) -> const Point_3& {
      const Vertex_handle v = c->vertex(i);
      return is_numbered(v, m_vertices) ? m_proposal[v->scratch_index()] : v->point();
    };
    return m_complex.geom_traits().orientation_3_object()(point(0), point(1), point(2), point(3)) ==
           POSITIVE;
  }

  // Holds back the vertices of cells that would not be positive, and those around. Returns all of them.
  std::vector<std::uint32_t> hold_back(const std::vector<Cell_handle>& cells)
  {
    std::vector<char> is_bad(cells.size());
    m_for_each_index(cells.size(), [&](std::size_t i) { is_bad[i] = !is_positive(cells[i]); });
    std::vector<std::uint32_t> held;
    for (std::size_t k = 0; k < cells.size(); ++k)
      if (is_bad[k])
        for (int i = 0; i < 4; ++i) {
          const Vertex_handle v = cells[k]->vertex(i);
          if (is_numbered(v, m_vertices) && m_way[v->scratch_index()] > 0)
            held.push_back(v->scratch_index());
        }
    std::sort(held.begin(), held.end());
    held.erase(std::unique(held.begin(), held.end()), held.end());
    for (std::uint32_t i : held)
      set_way(i, m_way[i] / 2);

    std::vector<Cell_handle> star;
    for (std::size_t k = 0; k < held.size(); ++k) {
      const Vertex_handle v = m_vertices[held[k]];
      m_complex.star(v, star);
      for (Cell_handle c : star)
        for (int j = 0; j < 4; ++j)
          if (c->vertex(j) != v && is_numbered(c->vertex(j), m_vertices) &&
              follow(c->vertex(j)->scratch_index(), held[k]))
            held.push_back(c->vertex(j)->scratch_index());
    }
    return held;
  }

  // Bounds the way of a vertex by that of its neighbor. Returns whether it got shorter.
  bool follow(std::uint32_t i, std::uint32_t neighbor)
  {
    const double length = std::sqrt(
        (m_complex.position(m_vertices[i]) - m_complex.position(m_vertices[neighbor]))
            .squared_length());
    const double distance = std::sqrt(displacement(i).squared_length());
    const double bound = m_way[neighbor] + lead * length / distance;
    if (!(m_way[i] > bound))
      return false;
    set_way(i, bound);
    return true;
  }

  Vector displacement(std::uint32_t i) const
  {
    return m_complex.geom_traits().construct_approximate_point_3_object()(m_targets[i]) -
           m_complex.position(m_vertices[i]);
  }

  void set_way(std::uint32_t i, double way)
  {
    m_way[i] = way < shortest_way ? 0 : way;
    m_proposal[i] = m_way[i] == 0 ? m_vertices[i]->point()
                                  : m_complex.geom_traits().construct_exact_point_3_object()(
                                        m_complex.position(m_vertices[i]) + m_way[i] * displacement(i));
  }

  Complex& m_complex;
  const For_each_index& m_for_each_index;
  const std::vector<Vertex_handle>& m_vertices;
  const std::vector<Point_3>& m_targets;
  std::vector<Cell_handle> m_cells;
  std::vector<Point_3> m_proposal;
  std::vector<double> m_way; // the part of the way that each vertex goes
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_SIMULTANEOUS_MOTION_3_H
