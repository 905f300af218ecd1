// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_SIMULTANEOUS_MOTION_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_SIMULTANEOUS_MOTION_H

#include <CGAL/Deformable_simplicial_complexes/internal/motion/Proposed_motion.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/untangling.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

/*
Holds vertices back where cells would invert: each goes half of its way, then a quarter, and so on.
So that a vertex held back does not shear the cells around it, its neighbors get ahead of it by a
part of the edge between them at the most, theirs again, and so on; farther away nothing is held
back.
*/
template <class Complex> class Holding_back
{
public:
  using Motion = Proposed_motion<Complex>;
  using Number = typename Motion::Number;
  using Cell_handle = typename Complex::Cell_handle;
  using Vertex_handle = typename Complex::Vertex_handle;
  using Point = typename Complex::Point;

  explicit Holding_back(Motion& motion) : m_motion(motion), m_way(motion.size(), 1.) {
    m_targets.reserve(motion.size());
    for (Number i = 0; i < motion.size(); ++i)
      m_targets.push_back(motion.point(i));
  }

  // Runs until no cell inverts or degrades, given those that would. The rounds end because in each
  // a vertex is held back further, and cells whose vertices all stay are positive.
  void run(std::vector<Cell_handle> bad) {
    while (!bad.empty())
      bad = m_motion.bad_cells(m_motion.stars(hold_back(bad)));
  }

private:
  static constexpr double shortest_way = 1. / 16; // below, a vertex stays
  static constexpr double lead = .25;             // of an edge, by which one end may get ahead

  // Holds back the moving vertices of cells, and those around. Returns all of them.
  std::vector<Number> hold_back(const std::vector<Cell_handle>& cells) {
    std::vector<Number> held = m_motion.vertices_of(cells, [&](Number i) { return m_way[i] > 0; });
    for (Number i : held)
      set_way(i, m_way[i] / 2);

    std::vector<Cell_handle> star;
    for (std::size_t k = 0; k < held.size(); ++k) {
      const Vertex_handle v = m_motion.vertex(held[k]);
      m_motion.complex().star(v, star);
      for (Cell_handle c : star)
        for (int j = 0; j < Complex::corners; ++j)
          if (c->vertex(j) != v && m_motion.has(c->vertex(j)) &&
              follow(m_motion.number(c->vertex(j)), held[k],
                     m_motion.complex().displacement(v, c->vertex(j))))
            held.push_back(m_motion.number(c->vertex(j)));
    }
    return held;
  }

  // Bounds the way of a vertex by that of its neighbor. Returns whether it got shorter.
  bool follow(Number i, Number neighbor, const typename Complex::Approximate_vector& edge) {
    const double length = std::sqrt(edge.squared_length());
    const double distance = std::sqrt(displacement(i).squared_length());
    const double bound = m_way[neighbor] + lead * length / distance;
    if (!(m_way[i] > bound))
      return false;
    set_way(i, bound);
    return true;
  }

  typename Complex::Approximate_vector displacement(Number i) const {
    const Complex& complex = m_motion.complex();
    return complex.displacement(m_motion.vertex(i), complex.approximate(m_targets[i]));
  }

  void set_way(Number i, double way) {
    const Vertex_handle v = m_motion.vertex(i);
    const auto motion = displacement(i);
    m_way[i] = way < shortest_way || !std::isfinite(motion.squared_length()) ? 0 : way;
    m_motion.set_point(i, m_way[i] == 0 ? v->point()
                                        : m_motion.complex().exact(m_motion.complex().position(v) +
                                                                   m_way[i] * motion));
  }

  Motion& m_motion;
  std::vector<Point> m_targets;
  std::vector<double> m_way; // the part of the way that each vertex goes
};

/*
Moves vertices towards their targets all at once, as far as no cell inverts or falls below the
quality floor. Where a cell would, its free vertices look for a better place; if there is none, its
moving vertices are held back. Returns the cells around the vertices.

With every cell positive and the boundary of the domain in place, the map from the old to the new
complex is a homeomorphism: nothing was passed through on the way.
*/
template <class Complex>
std::vector<typename Complex::Cell_handle>
move_simultaneously(Complex& complex, const std::vector<typename Complex::Vertex_handle>& vertices,
                    const std::vector<typename Complex::Point>& targets,
                    const For_each_index& for_each_index) {
  Proposed_motion<Complex> motion(complex, vertices, targets, for_each_index);
  auto bad = motion.inverted_cells();
  do {
    bad = untangle(motion, std::move(bad));
    Holding_back<Complex>(motion).run(std::move(bad));
    bad = motion.degraded_cells();
  } while (!bad.empty());
  motion.commit();
  return motion.cells();
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_SIMULTANEOUS_MOTION_H
