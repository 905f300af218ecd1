// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_SIMULTANEOUS_MOTION_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_SIMULTANEOUS_MOTION_3_H

#include <CGAL/Deformable_simplicial_complex_3/internal/For_each_index.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/star_union.h>

#include <CGAL/Origin.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

/*
Moves vertices towards their targets all at once, as far as no cell inverts. Where a cell would, its
free vertices look for a better place among their neighbors; if there is none, its moving vertices
are held back: each goes half of its way, then a quarter, and so on. So that a vertex held back does
not shear the cells around it, its neighbors get ahead of it by a part of the edge between them at
the most, theirs again, and so on; farther away nothing is held back.

With every cell positive and the boundary of the domain in place, the map from the old to the new
complex is a homeomorphism: nothing was passed through on the way.
*/
template <class Complex> class Simultaneous_motion_3
{
public:
  using Cell_handle = typename Complex::Cell_handle;
  using Vertex_handle = typename Complex::Vertex_handle;
  using Point_3 = typename Complex::Point_3;
  using Vector = typename Complex::Approximate_vector_3;

  Simultaneous_motion_3(Complex& complex, const std::vector<Vertex_handle>& vertices,
                        const std::vector<Point_3>& targets, const For_each_index& for_each_index)
      : m_complex(complex), m_for_each_index(for_each_index), m_vertices(vertices),
        m_targets(targets), m_proposal(targets), m_way(vertices.size(), 1.) {
    number_vertices(vertices);
    m_cells = star_union(complex, vertices);
  }

  // Returns the cells around the vertices. The rounds end because in each a
  // vertex is held back further, and cells whose vertices all stay are positive.
  const std::vector<Cell_handle>& run() {
    std::vector<Cell_handle> unchecked = m_cells;
    untangle(bad_cells(unchecked));
    while (!unchecked.empty())
      unchecked = stars(hold_back(bad_cells(unchecked)));
    m_complex.set_points(m_vertices, m_proposal, m_cells, m_for_each_index);
    return m_cells;
  }

private:
  static constexpr double shortest_way = 1. / 16; // below, a vertex stays
  static constexpr double lead = .25;             // of an edge, by which one end may get ahead

  bool is_positive(Cell_handle c) const {
    const auto point = [&](int i) -> const Point_3& { return proposed_point(c->vertex(i)); };
    return m_complex.geom_traits().orientation_3_object()(point(0), point(1), point(2), point(3)) ==
           POSITIVE;
  }

  // Those that would not be positive.
  std::vector<Cell_handle> bad_cells(const std::vector<Cell_handle>& cells) const {
    std::vector<char> is_bad(cells.size());
    m_for_each_index(cells.size(), [&](std::size_t i) { is_bad[i] = !is_positive(cells[i]); });
    std::vector<Cell_handle> result;
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (is_bad[i])
        result.push_back(cells[i]);
    return result;
  }

  // The finite cells around vertices; some more than once.
  std::vector<Cell_handle> stars(const std::vector<std::uint32_t>& vertices) const {
    std::vector<Cell_handle> result, star;
    for (std::uint32_t i : vertices) {
      m_complex.star(m_vertices[i], star);
      for (Cell_handle c : star)
        if (!m_complex.is_infinite(c))
          result.push_back(c);
    }
    return result;
  }

  // The moving vertices of cells for which a condition on the number holds, by number.
  template <class Condition>
  std::vector<std::uint32_t> vertices_of(const std::vector<Cell_handle>& cells,
                                         const Condition& condition) const {
    std::vector<std::uint32_t> result;
    for (Cell_handle c : cells)
      for (int i = 0; i < 4; ++i) {
        const Vertex_handle v = c->vertex(i);
        if (is_numbered(v, m_vertices) && condition(v->scratch_index()))
          result.push_back(v->scratch_index());
      }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // Lets the free vertices of cells look for better targets, and those around them if that is not
  // enough.
  void untangle(std::vector<Cell_handle> cells) {
    static constexpr int rounds = 4, rounds_without_neighbors = 2;
    const auto is_free = [&](std::uint32_t i) { return !m_vertices[i]->is_interface(); };
    for (int round = 0; round < rounds && !cells.empty(); ++round) {
      if (round >= rounds_without_neighbors)
        cells = stars(vertices_of(cells, is_free));
      const std::vector<std::uint32_t> free = vertices_of(cells, is_free);
      for (std::uint32_t i : free)
        relocate(i);
      cells = bad_cells(stars(free));
    }
  }

  // Proposes two other targets to a free vertex, and takes what is better for its star: going along
  // with the interface around, and the mean of the neighbors.
  void relocate(std::uint32_t i) {
    const Vertex_handle v = m_vertices[i];
    std::vector<Cell_handle> star;
    m_complex.star(v, star);
    Vector motion(0, 0, 0), mean(0, 0, 0);
    int moving = 0;
    for (Cell_handle c : star)
      for (int j = 0; j < 4; ++j) {
        const Vertex_handle w = c->vertex(j);
        if (w == v)
          continue;
        mean = mean + (proposed_position(w) - CGAL::ORIGIN) / double(3 * star.size());
        if (w->is_interface()) {
          motion = motion + (proposed_position(w) - m_complex.position(w));
          ++moving;
        }
      }
    double worst = worst_quality(star, -std::numeric_limits<double>::infinity());
    for (double way : {.5, 1.}) {
      if (moving > 0)
        propose(i, star, way, m_complex.position(v) + motion / moving, worst);
      propose(i, star, way, CGAL::ORIGIN + mean, worst);
    }
  }

  // A part of the way from the target to another one, if the worst quality of the star rises.
  void propose(std::uint32_t i, const std::vector<Cell_handle>& star, double way,
               const typename Complex::Approximate_point_3& target, double& worst) {
    const auto from = proposed_position(m_vertices[i]);
    m_proposal[i] =
        m_complex.geom_traits().construct_exact_point_3_object()(from + way * (target - from));
    const double after = worst_quality(star, worst);
    if (after > worst) {
      worst = after;
      m_targets[i] = m_proposal[i];
    } else {
      m_proposal[i] = m_targets[i];
    }
  }

  // The worst quality, or one that is not above the bound.
  double worst_quality(const std::vector<Cell_handle>& star, double bound) const {
    double worst = std::numeric_limits<double>::infinity();
    for (Cell_handle c : star) {
      worst = (std::min)(worst, m_complex.quality_measure()(proposed_position(c->vertex(0)),
                                                            proposed_position(c->vertex(1)),
                                                            proposed_position(c->vertex(2)),
                                                            proposed_position(c->vertex(3))));
      if (!(worst > bound))
        break;
    }
    return worst;
  }

  const Point_3& proposed_point(Vertex_handle v) const {
    return is_numbered(v, m_vertices) ? m_proposal[v->scratch_index()] : v->point();
  }

  typename Complex::Approximate_point_3 proposed_position(Vertex_handle v) const {
    return m_complex.geom_traits().construct_approximate_point_3_object()(proposed_point(v));
  }

  // Holds back the moving vertices of cells, and those around. Returns all of them.
  std::vector<std::uint32_t> hold_back(const std::vector<Cell_handle>& cells) {
    std::vector<std::uint32_t> held =
        vertices_of(cells, [&](std::uint32_t i) { return m_way[i] > 0; });
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
  bool follow(std::uint32_t i, std::uint32_t neighbor) {
    const double length =
        std::sqrt((m_complex.position(m_vertices[i]) - m_complex.position(m_vertices[neighbor]))
                      .squared_length());
    const double distance = std::sqrt(displacement(i).squared_length());
    const double bound = m_way[neighbor] + lead * length / distance;
    if (!(m_way[i] > bound))
      return false;
    set_way(i, bound);
    return true;
  }

  Vector displacement(std::uint32_t i) const {
    return m_complex.geom_traits().construct_approximate_point_3_object()(m_targets[i]) -
           m_complex.position(m_vertices[i]);
  }

  void set_way(std::uint32_t i, double way) {
    m_way[i] = way < shortest_way || !std::isfinite(displacement(i).squared_length()) ? 0 : way;
    m_proposal[i] = m_way[i] == 0
                        ? m_vertices[i]->point()
                        : m_complex.geom_traits().construct_exact_point_3_object()(
                              m_complex.position(m_vertices[i]) + m_way[i] * displacement(i));
  }

  Complex& m_complex;
  const For_each_index& m_for_each_index;
  const std::vector<Vertex_handle>& m_vertices;
  std::vector<Point_3> m_targets;
  std::vector<Cell_handle> m_cells;
  std::vector<Point_3> m_proposal;
  std::vector<double> m_way; // the part of the way that each vertex goes
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_SIMULTANEOUS_MOTION_3_H
