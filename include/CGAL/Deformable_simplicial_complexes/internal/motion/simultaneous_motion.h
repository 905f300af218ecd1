// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_SIMULTANEOUS_MOTION_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_SIMULTANEOUS_MOTION_H

#include <CGAL/Deformable_simplicial_complexes/internal/motion/Proposed_motion.h>
#include <CGAL/Mesh_support/coordinates.h>

#include <CGAL/Origin.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Proposes other points for a free vertex, and keeps the point with the best star quality. The
// candidates are the mean motion of the interface vertices around and the mean of the neighbors,
// each with step lengths 1 and 1/2.
template <class Complex>
void relocate(Proposed_motion<Complex>& motion, typename Proposed_motion<Complex>::Number i) {
  using Cell_handle = typename Complex::Cell_handle;
  using Vertex_handle = typename Complex::Vertex_handle;
  using Vector = typename Complex::Vector;
  using Position = typename Complex::Point;
  const Complex& complex = motion.complex();
  const Vertex_handle v = motion.vertex(i);
  std::vector<Cell_handle> star;
  complex.star(v, star);
  star.erase(std::remove_if(star.begin(), star.end(),
                            [&](Cell_handle c) { return complex.is_infinite(c); }),
             star.end());
  Vector sum_of_motions(CGAL::NULL_VECTOR), mean(CGAL::NULL_VECTOR);
  int moving = 0;
  const Position start = complex.position(v);
  for (Cell_handle c : star) {
    for (int j = 0; j < Complex::corners; ++j) {
      const Vertex_handle w = c->vertex(j);
      if (w == v)
        continue;
      const Position seen = complex.domain().nearest_image(start, motion.position(w));
      mean = mean + (seen - CGAL::ORIGIN) / double(Complex::dimension * star.size());
      if (w->is_interface()) {
        sum_of_motions = sum_of_motions + complex.displacement(w, motion.position(w));
        ++moving;
      }
    }
  }
  double worst = motion.worst_quality(star, -std::numeric_limits<double>::infinity());
  const auto propose = [&](double fraction, const Position& target) {
    if (!has_finite_coordinates(target))
      return;
    const auto before = motion.point(i);
    const Position from = motion.position(v);
    motion.set_point(
        i, complex.admissible_destination(
               v, from + fraction * (complex.domain().nearest_image(from, target) - from)));
    const double after = motion.worst_quality(star, worst);
    if (after > worst)
      worst = after;
    else
      motion.set_point(i, before);
  };
  for (double fraction : {.5, 1.}) {
    if (moving > 0)
      propose(fraction, start + sum_of_motions / moving);
    propose(fraction, CGAL::ORIGIN + mean);
  }
}

// Relocates the free vertices of cells that would be inverted. Returns the cells that would still
// be inverted.
template <class Complex>
std::vector<typename Complex::Cell_handle>
untangle(Proposed_motion<Complex>& motion, std::vector<typename Complex::Cell_handle> cells) {
  static constexpr int rounds = 2; // more rounds are slow and seldom help
  const auto is_free = [&](auto i) { return !motion.vertex(i)->is_interface(); };
  auto suspects = cells;
  for (int round = 0; round < rounds && !cells.empty(); ++round) {
    const auto free = motion.vertices_of(cells, is_free);
    for (auto i : free)
      relocate(motion, i);
    const auto around = motion.stars(free);
    suspects.insert(suspects.end(), around.begin(), around.end());
    cells = motion.bad_cells(around);
  }
  return motion.bad_cells(suspects);
}

/*
A reduction of displacements where cells would be inverted. The displacement of a vertex is halved,
then halved again, and so on. The neighbors of the vertex are reduced, too, so that the cells around
it are not sheared: along each edge, the moved fractions differ by at most a quarter of the edge
length relative to the displacement. Vertices farther away keep their displacements.
*/
template <class Complex> class Displacement_reduction
{
public:
  using Motion = Proposed_motion<Complex>;
  using Number = typename Motion::Number;
  using Cell_handle = typename Complex::Cell_handle;
  using Vertex_handle = typename Complex::Vertex_handle;
  using Point = typename Complex::Point;

  explicit Displacement_reduction(Motion& motion)
      : m_motion(motion), m_targets(motion.points()), m_fractions(m_targets.size(), 1.) {}

  // Runs until no cell is inverted or degraded, starting with the given bad cells. This terminates:
  // each round reduces a displacement further, and cells whose vertices all stay are positively
  // oriented.
  void run(std::vector<Cell_handle> bad) {
    while (!bad.empty())
      bad = m_motion.bad_cells(m_motion.stars(reduce(bad)));
  }

private:
  static constexpr double smallest_fraction = 1. / 16; // smaller fractions are set to 0
  static constexpr double lead = .25; // of the edge length: maximum difference along an edge

  // Halves the displacements of the moving vertices of cells, and reduces the displacements of the
  // vertices around them. Returns all vertices with a reduced displacement.
  std::vector<Number> reduce(const std::vector<Cell_handle>& cells) {
    std::vector<Number> reduced =
        m_motion.vertices_of(cells, [&](Number i) { return m_fractions[i] > 0; });
    for (Number i : reduced)
      set_fraction(i, m_fractions[i] / 2);

    std::vector<Cell_handle> star;
    for (std::size_t k = 0; k < reduced.size(); ++k) {
      const Vertex_handle v = m_motion.vertex(reduced[k]);
      m_motion.complex().star(v, star);
      for (Cell_handle c : star)
        for (int j = 0; j < Complex::corners; ++j)
          if (c->vertex(j) != v && m_motion.has(c->vertex(j)) &&
              follow(m_motion.number(c->vertex(j)), reduced[k],
                     m_motion.complex().displacement(v, c->vertex(j))))
            reduced.push_back(m_motion.number(c->vertex(j)));
    }
    return reduced;
  }

  // Bounds the moved fraction of a vertex by the fraction of its neighbor. Returns whether the
  // fraction was reduced.
  bool follow(Number i, Number neighbor, const typename Complex::Vector& edge) {
    const double length = std::sqrt(edge.squared_length());
    const double distance = std::sqrt(displacement(i).squared_length());
    const double bound = m_fractions[neighbor] + lead * length / distance;
    if (!(m_fractions[i] > bound))
      return false;
    set_fraction(i, bound);
    return true;
  }

  typename Complex::Vector displacement(Number i) const {
    const Complex& complex = m_motion.complex();
    return complex.displacement(m_motion.vertex(i), m_targets[i]);
  }

  void set_fraction(Number i, double fraction) {
    const Vertex_handle v = m_motion.vertex(i);
    const auto motion = displacement(i);
    m_fractions[i] =
        fraction < smallest_fraction || !std::isfinite(motion.squared_length()) ? 0 : fraction;
    m_motion.set_point(i, m_fractions[i] == 0
                              ? v->point()
                              : m_motion.complex().position(v) + m_fractions[i] * motion);
  }

  Motion& m_motion;
  std::vector<Point> m_targets;
  std::vector<double> m_fractions; // fraction of the displacement of each vertex
};

// Relocates the free vertices of all cells that would be inverted or degraded. Returns the cells
// that still would be.
template <class Complex>
std::vector<typename Complex::Cell_handle> untangle(Proposed_motion<Complex>& motion) {
  auto bad = untangle(motion, motion.inverted_cells());
  return bad.empty() ? untangle(motion, motion.degraded_cells()) : bad;
}

// Replaces all displacements by the same fraction of them, 1, 1/2, ... 1/32, so that no cell would
// be inverted or, if `may_degrade` is false, degraded. Returns whether this is possible; otherwise,
// the displacements stay.
template <class Complex> bool shorten(Proposed_motion<Complex>& motion, bool may_degrade) {
  static constexpr double smallest_fraction = 1. / 32;
  using Number = typename Proposed_motion<Complex>::Number;
  const Complex& complex = motion.complex();
  const std::vector<typename Complex::Point> targets = motion.points();
  for (double fraction = 1; fraction >= smallest_fraction; fraction /= 2) {
    if (fraction < 1)
      for (Number i : motion.moving()) {
        const auto v = motion.vertex(i);
        const auto displacement = complex.displacement(v, targets[i]);
        motion.set_point(
            i, complex.admissible_destination(v, complex.position(v) + fraction * displacement));
      }
    if (untangle(motion).empty() || (may_degrade && motion.inverted_cells().empty()))
      return true;
  }
  for (Number i : motion.moving())
    motion.set_point(i, targets[i]);
  return false;
}

/*
Moves vertices simultaneously to their proposed points, as far as no cell is inverted or falls below
the quality floor. Where a cell would be inverted, its free vertices are relocated. If this does not
help, the displacements of its moving vertices are reduced. If `is_rigid(bad_cells)` returns true,
the displacements of all vertices are reduced alike. Cells may then fall below the quality floor if
no fraction avoids it. Returns the cells that made it necessary to treat all displacements alike.

All cells stay positively oriented and the boundary of the domain stays in place. Thus the map from
the old to the new complex is a homeomorphism.
*/
template <class Complex, class Is_rigid>
std::vector<typename Complex::Cell_handle> move_simultaneously(Proposed_motion<Complex>& motion,
                                                               const Is_rigid& is_rigid) {
  auto bad = untangle(motion);
  std::vector<typename Complex::Cell_handle> obstructing;
  if (!bad.empty() && is_rigid(bad) && (shorten(motion, false) || shorten(motion, true)))
    obstructing.swap(bad);
  for (;;) {
    Displacement_reduction<Complex>(motion).run(std::move(bad));
    bad = motion.degraded_cells(); // also measures the qualities of changed cells
    if (bad.empty() || !obstructing.empty())
      break;
    bad = untangle(motion, std::move(bad));
  }
  motion.commit();
  return obstructing;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_SIMULTANEOUS_MOTION_H
