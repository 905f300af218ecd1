// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_NEIGHBOR_EXCHANGE_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_NEIGHBOR_EXCHANGE_2_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_energy.h>
#include <CGAL/Deformable_simplicial_complexes/Neighbor_exchange.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

/*
Cells around a wall: an edge of the interface from a to b, whose ends are vertices where three
phases meet. A is on the left of the wall, B on its right, C at a, and D at b.

After the exchange, a is the junction of A, C and D, and b that of B, C and D. The polygon around
the two vertices stays. Its sides in A are connected with a, and those in B with b. Its sides in C
and D are divided between a and b so that the worst quality is best.
*/
template <class Complex> class Wall_surroundings
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  using Label = typename Complex::Label;
  using Point = typename Complex::Approximate_point;
  using Index = typename Cavity<Complex>::Index;

  // Constructs the cells around the edge opposite to the vertex i of a cell in A.
  Wall_surroundings(const Complex& complex, Cell_handle cell, int i)
      : m_complex(complex), m_a(cell->vertex((i + 1) % 3)), m_b(cell->vertex((i + 2) % 3)),
        m_cell(cell), m_other(cell->neighbor(i)) {}

  // Collects the polygon. Returns whether the phases are as described above.
  bool collect() {
    if (m_complex.is_boundary(m_a) || m_complex.is_boundary(m_b))
      return false;
    walk(m_a, m_cell, m_other);
    walk(m_b, m_other, m_cell);
    const Label left = m_cell->label(), right = m_other->label();
    std::size_t k = skip(0, left);
    m_ends[0] = k;
    if (k == m_sides.size())
      return false;
    m_beyond[0] = label(k);
    m_ends[1] = skip(k, m_beyond[0]);
    m_ends[2] = skip(m_ends[1], right);
    if (m_ends[2] == m_sides.size())
      return false;
    m_beyond[1] = label(m_ends[2]);
    m_ends[3] = skip(m_ends[2], m_beyond[1]);
    const bool has_three_phases_at_each = m_beyond[0] != right && m_beyond[1] != left &&
                                          m_ends[1] < m_sides_of_a + 1 &&
                                          m_ends[2] + 1 > m_sides_of_a;
    const bool a_has_sides = m_ends[0] > 0 || m_ends[3] < m_sides.size(),
               b_has_sides = m_ends[1] < m_ends[2];
    return has_three_phases_at_each && skip(m_ends[3], left) == m_sides.size() && a_has_sides &&
           b_has_sides;
  }

  Label beyond(int end) const { return m_beyond[end]; }
  Point middle() const { return m_complex.position(m_a) + m_complex.displacement(m_a, m_b) / 2; }

  // Returns the length of the wall divided by the mean length of the four other interface edges at
  // its ends.
  double relative_length() const {
    double sum = 0;
    for (int end = 0; end < 4; ++end)
      sum += std::sqrt(
          m_complex.displacement(end < 2 ? m_a : m_b, corner(m_ends[end])).squared_length());
    return 4 * std::sqrt(m_complex.displacement(m_a, m_b).squared_length()) / sum;
  }

  // Plans the exchange, with a new wall whose length is a fraction of the old one. Returns the
  // change of the energy of the interface; nothing if a cell would not be positively oriented or
  // would not keep its quality.
  std::optional<double> plan(double part, const Interface_energy& energy,
                             Cavity<Complex>& cavity) const {
    cavity.begin(Proposal_kind::replacement);
    for (const auto& side : m_sides)
      cavity.remove(side.cell);
    cavity.remove(m_cell);
    cavity.remove(m_other);
    const auto wall = m_complex.displacement(m_a, m_b);
    const Point m = middle();
    const decltype(wall) across(-wall.y() * part / 2, wall.x() * part / 2);
    const Point to_a = m + across, to_b = m - across;
    const Index a = cavity.add(m_a, m_complex.exact(to_a)),
                b = cavity.add(m_b, m_complex.exact(to_b));
    for (std::size_t k = m_ends[3]; k < m_sides.size(); ++k)
      create(cavity, k, a);
    for (std::size_t k = 0; k < m_ends[0]; ++k)
      create(cavity, k, a);
    divide(cavity, m_ends[0], m_ends[1], a, b);
    for (std::size_t k = m_ends[1]; k < m_ends[2]; ++k)
      create(cavity, k, b);
    divide(cavity, m_ends[2], m_ends[3], b, a);
    if (!cavity.is_admissible())
      return std::nullopt;

    const auto length = [&](const Point& p, std::size_t k) {
      return std::sqrt((m_complex.position_near(p, corner(k)) - p).squared_length());
    };
    const Point from_a = m_complex.position(m_a), from_b = m_complex.position(m_b);
    const Label left = m_cell->label(), right = m_other->label();
    const double old_wall = std::sqrt(wall.squared_length());
    double result = -energy.tension(left, right) * old_wall;
    if (m_beyond[0] != m_beyond[1])
      result += energy.tension(m_beyond[0], m_beyond[1]) * part * old_wall;
    const std::array<Label, 4> one = {left, m_beyond[0], right, m_beyond[1]},
                               other = {m_beyond[0], right, m_beyond[1], left};
    for (std::size_t end = 0; end < 4; ++end) {
      const Point &from = end < 2 ? from_a : from_b, &to = end % 3 == 0 ? to_a : to_b;
      result += energy.tension(one[end], other[end]) *
                (length(to, m_ends[end]) - length(from, m_ends[end]));
    }
    return result;
  }

private:
  // Side of the polygon, counterclockwise, with its inner cell.
  struct Side
  {
    Vertex_handle from, to;
    Cell_handle cell;
  };

  // Adds the sides opposite to v between two cells around it, counterclockwise.
  void walk(Vertex_handle v, Cell_handle first, Cell_handle last) {
    for (Cell_handle c = next(v, first); c != last; c = next(v, c)) {
      const int i = c->index(v);
      m_sides.push_back({c->vertex((i + 1) % 3), c->vertex((i + 2) % 3), c});
    }
    if (v == m_a)
      m_sides_of_a = m_sides.size();
  }
  static Cell_handle next(Vertex_handle v, Cell_handle c) {
    return c->neighbor((c->index(v) + 1) % 3);
  }

  Label label(std::size_t k) const { return m_sides[k].cell->label(); }
  std::size_t skip(std::size_t k, Label label) const {
    while (k < m_sides.size() && this->label(k) == label)
      ++k;
    return k;
  }

  // Returns the first vertex of side k.
  Vertex_handle corner(std::size_t k) const { return m_sides[k % m_sides.size()].from; }

  typename Cavity<Complex>::Indices triangle(Cavity<Complex>& cavity, std::size_t k,
                                             Index apex) const {
    return {apex, cavity.add(m_sides[k].from), cavity.add(m_sides[k].to)};
  }
  void create(Cavity<Complex>& cavity, std::size_t k, Index apex) const {
    cavity.create(triangle(cavity, k, apex), m_sides[k].cell);
  }

  // Connects the first sides of a phase at an end of the wall with the vertex `one`, and the others
  // with the vertex `other`.
  void divide(Cavity<Complex>& cavity, std::size_t first, std::size_t last, Index one,
              Index other) const {
    std::size_t best = first;
    double best_quality = -std::numeric_limits<double>::infinity();
    for (std::size_t j = first; j <= last; ++j) {
      double quality = cavity.quality({one, cavity.add(corner(j)), other});
      for (std::size_t k = first; k < last; ++k)
        quality = (std::min)(quality, cavity.quality(triangle(cavity, k, k < j ? one : other)));
      if (quality > best_quality) {
        best = j;
        best_quality = quality;
      }
    }
    cavity.create({one, cavity.add(corner(best)), other}, m_sides[first].cell);
    for (std::size_t k = first; k < last; ++k)
      create(cavity, k, k < best ? one : other);
  }

  const Complex& m_complex;
  Vertex_handle m_a, m_b;
  Cell_handle m_cell, m_other;
  std::vector<Side> m_sides; // from the corner of A opposite to the wall
  std::size_t m_sides_of_a = 0;
  std::array<std::size_t, 4> m_ends; // ends of the sides in A, C, B and D
  std::array<Label, 2> m_beyond;     // labels of C and D
};

} // namespace internal

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to exchange neighbors (T1 event). The phases on both sides of a short wall are separated,
and the two phases at its ends become neighbors. The wall is one edge of the interface between two
vertices where three phases meet. It is replaced by a wall perpendicular to it. Linear in the stars
of the two vertices, but quadratic in the phases at the ends.

\param complex the complex; it is not changed
\param cell, i the edge opposite to the vertex i of a finite triangle
\param longest largest length of walls to be considered, divided by the mean length of the four
       other interface edges at the ends of the wall
\param cavity filled with the proposal if there is one; the ends of the wall move
\param energy the energy of the interface; energy densities have no effect. The default is the
       length.
\return the exchange, if it decreases the energy of the interface, all new triangles are positively
        oriented, and `complex.keeps_quality()` holds
\throws Error if a tension is out of its range
*/
template <class Complex>
std::optional<Neighbor_exchange<Complex>>
propose_neighbor_exchange(const Complex& complex, typename Complex::Cell_handle cell, int i,
                          double longest, Deformable_simplicial_complexes::Cavity<Complex>& cavity,
                          const Interface_energy& energy = {}) {
  using namespace internal;
  if (!complex.is_interface(typename Complex::Facet(cell, i)))
    return std::nullopt;
  Wall_surroundings<Complex> surroundings(complex, cell, i);
  if (!surroundings.collect() || !(surroundings.relative_length() < longest))
    return std::nullopt;
  for (double part : {1., .5, .25})
    if (const auto growth = surroundings.plan(part, energy, cavity); growth && *growth < 0)
      return Neighbor_exchange<Complex>{{cell->label(), cell->neighbor(i)->label()},
                                        {surroundings.beyond(0), surroundings.beyond(1)},
                                        complex.domain().canonical(surroundings.middle())};
  return std::nullopt;
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_NEIGHBOR_EXCHANGE_2_H
