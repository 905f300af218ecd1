// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_NEIGHBOR_EXCHANGE_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_NEIGHBOR_EXCHANGE_2_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_energy.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// The sides of a polygon of cells, counterclockwise, numbered cyclically: any number is valid.
template <class Complex> class Polygon_sides
{
public:
  using Cell_handle = typename Complex::Cell_handle;
  using Index = typename Cavity<Complex>::Index;

  struct Side
  {
    typename Complex::Vertex_handle from, to;
    Cell_handle cell; // inside
  };

  std::size_t size() const { return m_sides.size(); }
  const Side& operator[](std::size_t k) const { return m_sides[k % m_sides.size()]; }
  auto begin() const { return m_sides.begin(); }
  auto end() const { return m_sides.end(); }

  // Adds the side of a cell that is opposite to the vertex i.
  void add(Cell_handle c, int i) {
    m_sides.push_back({c->vertex((i + 1) % 3), c->vertex((i + 2) % 3), c});
  }

  // Connects sides with a vertex.
  void connect(Cavity<Complex>& cavity, std::size_t first, std::size_t last, Index apex) const {
    for (std::size_t k = first; k < last; ++k)
      cavity.create(triangle(cavity, k, apex), (*this)[k].cell);
  }

  // Connects the first ones of some sides with the vertex `one`, and the others with the vertex
  // `other`, so that the worst quality is best.
  void divide(Cavity<Complex>& cavity, std::size_t first, std::size_t last, Index one,
              Index other) const {
    const auto between = [&](std::size_t k) -> typename Cavity<Complex>::Indices {
      return {one, cavity.add((*this)[k].from), other};
    };
    std::size_t best = first;
    double best_quality = -std::numeric_limits<double>::infinity();
    for (std::size_t j = first; j <= last; ++j) {
      double quality = cavity.quality(between(j));
      for (std::size_t k = first; k < last; ++k)
        quality = (std::min)(quality, cavity.quality(triangle(cavity, k, k < j ? one : other)));
      if (quality > best_quality) {
        best = j;
        best_quality = quality;
      }
    }
    cavity.create(between(best), (*this)[first].cell);
    connect(cavity, first, best, one);
    connect(cavity, best, last, other);
  }

private:
  typename Cavity<Complex>::Indices triangle(Cavity<Complex>& cavity, std::size_t k,
                                             Index apex) const {
    return {apex, cavity.add((*this)[k].from), cavity.add((*this)[k].to)};
  }

  std::vector<Side> m_sides;
};

/*
Cells around a wall: an edge of the interface from a to b, whose ends are vertices where three
phases meet. A is on the left of the wall, B on its right, C at a, and D at b.

After the exchange, a is the junction of A, C and D, and b that of B, C and D. The polygon around
the two vertices stays. Its sides in A are connected with a, and those in B with b. Its sides in C
and D are divided between a and b so that the worst quality is best.

If the wall ends at a side of a box, b is the end at this side, and D is the outside. After the
exchange, both vertices are on the side.
*/
template <class Complex> class Wall_surroundings
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  using Point = typename Complex::Point;
  using Index = typename Cavity<Complex>::Index;

  // Constructs the cells around the edge opposite to the vertex i of a finite cell.
  Wall_surroundings(const Complex& complex, Cell_handle cell, int i)
      : m_complex(complex), m_a(cell->vertex((i + 1) % 3)), m_b(cell->vertex((i + 2) % 3)),
        m_cell(cell), m_other(cell->neighbor(i)) {
    if (complex.is_boundary(m_a)) {
      std::swap(m_a, m_b);
      std::swap(m_cell, m_other);
    }
  }

  // Collects the polygon. Returns whether the phases are as described above.
  bool collect() {
    if (m_complex.is_boundary(m_a) || !is_free_or_on_one_side(m_b->boundary_class()))
      return false;
    walk(m_a, m_cell, m_other);
    walk(m_b, m_other, m_cell);
    const Phase left = phase(m_cell), right = phase(m_other);
    std::size_t k = skip(0, left);
    m_ends[0] = k;
    if (k == m_sides.size())
      return false;
    m_beyond[0] = phase(m_sides[k].cell);
    m_ends[1] = skip(k, m_beyond[0]);
    m_ends[2] = skip(m_ends[1], right);
    if (m_ends[2] == m_sides.size())
      return false;
    m_beyond[1] = phase(m_sides[m_ends[2]].cell);
    m_ends[3] = skip(m_ends[2], m_beyond[1]);
    const bool has_three_phases_at_each = m_beyond[0] != right && m_beyond[1] != left &&
                                          m_ends[1] < m_sides_of_a + 1 &&
                                          m_ends[2] + 1 > m_sides_of_a;
    const bool a_has_sides = m_ends[0] > 0 || m_ends[3] < m_sides.size(),
               b_has_sides = m_ends[1] < m_ends[2];
    return has_three_phases_at_each && skip(m_ends[3], left) == m_sides.size() && a_has_sides &&
           b_has_sides;
  }

  // Describes the exchange.
  Neighbor_exchange<Complex> exchange() const {
    return {{m_cell->subdomain_index(), m_other->subdomain_index()},
            {*m_beyond[0], m_beyond[1] ? *m_beyond[1] : *m_beyond[0]},
            m_complex.domain().canonical(middle())};
  }

  // Returns the length of the wall divided by the mean length of the four other interface edges at
  // its ends.
  double relative_length() const {
    double sum = 0;
    for (int end = 0; end < 4; ++end)
      sum += length_of(m_complex.displacement(end < 2 ? m_a : m_b, m_sides[m_ends[end]].from));
    return 4 * length_of(m_complex.displacement(m_a, m_b)) / sum;
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
    const Point from_a = m_complex.position(m_a), from_b = m_complex.position(m_b);
    const double old_wall = length_of(m_complex.displacement(m_a, m_b));
    const Vector half = across() * (part * old_wall / 2);
    const Point center = m_complex.is_boundary(m_b) ? from_b : middle();
    const Point to_a = center + half, to_b = center - half;
    // The inner end of a wall that ends at a side is replaced by a vertex on this side.
    const Index a = m_complex.is_boundary(m_b) ? cavity.add(to_a, m_b->boundary_class())
                                               : cavity.add(m_a, to_a),
                b = cavity.add(m_b, to_b);
    m_sides.connect(cavity, m_ends[3], m_sides.size(), a);
    m_sides.connect(cavity, 0, m_ends[0], a);
    m_sides.divide(cavity, m_ends[0], m_ends[1], a, b);
    m_sides.connect(cavity, m_ends[1], m_ends[2], b);
    m_sides.divide(cavity, m_ends[2], m_ends[3], b, a);
    if (!cavity.is_admissible())
      return std::nullopt;

    const auto length = [&](const Point& p, std::size_t k) {
      return length_of(m_complex.position_near(p, m_sides[k].from) - p);
    };
    const auto tension = [&](const Phase& p, const Phase& q) {
      return p && q && *p != *q ? energy.tension(*p, *q) : 0;
    };
    const Phase left = phase(m_cell), right = phase(m_other);
    double result = (tension(m_beyond[0], m_beyond[1]) * part - tension(left, right)) * old_wall;
    const std::array<Phase, 4> one = {left, m_beyond[0], right, m_beyond[1]},
                               other = {m_beyond[0], right, m_beyond[1], left};
    for (std::size_t end = 0; end < 4; ++end) {
      const Point &from = end < 2 ? from_a : from_b, &to = end % 3 == 0 ? to_a : to_b;
      result +=
          tension(one[end], other[end]) * (length(to, m_ends[end]) - length(from, m_ends[end]));
    }
    return result;
  }

private:
  using Vector = typename Complex::Vector;
  using Phase = std::optional<typename Complex::Label>; // empty for the outside of the domain

  // Adds the sides opposite to v between two cells around it, counterclockwise.
  void walk(Vertex_handle v, Cell_handle first, Cell_handle last) {
    for (Cell_handle c = next(v, first); c != last; c = next(v, c))
      m_sides.add(c, c->index(v));
    if (v == m_a)
      m_sides_of_a = m_sides.size();
  }
  static Cell_handle next(Vertex_handle v, Cell_handle c) {
    return c->neighbor((c->index(v) + 1) % 3);
  }

  static bool is_free_or_on_one_side(Boundary_class::Bits sides) {
    return (sides & Boundary_class::fixed) == 0 &&
           !(Boundary_class::fixes(sides, 0) && Boundary_class::fixes(sides, 1));
  }
  static double length_of(const Vector& v) { return std::sqrt(v.squared_length()); }

  Point middle() const { return m_complex.position(m_a) + m_complex.displacement(m_a, m_b) / 2; }

  // Returns the unit vector from b to a after the exchange: to the left of the wall, or along the
  // side at which the wall ends.
  Vector across() const {
    const Vector wall = m_complex.displacement(m_a, m_b);
    const auto sides = m_b->boundary_class();
    if (Boundary_class::fixes(sides, 0))
      return Vector(0, wall.x() < 0 ? -1 : 1);
    if (Boundary_class::fixes(sides, 1))
      return Vector(wall.y() < 0 ? 1 : -1, 0);
    return Vector(-wall.y(), wall.x()) / length_of(wall);
  }

  Phase phase(Cell_handle c) const {
    return m_complex.is_infinite(c) ? Phase() : Phase(c->subdomain_index());
  }
  std::size_t skip(std::size_t k, const Phase& phase) const {
    while (k < m_sides.size() && this->phase(m_sides[k].cell) == phase)
      ++k;
    return k;
  }

  const Complex& m_complex;
  Vertex_handle m_a, m_b;
  Cell_handle m_cell, m_other;
  Polygon_sides<Complex> m_sides; // from the corner of A opposite to the wall
  std::size_t m_sides_of_a = 0;
  std::array<std::size_t, 4> m_ends; // ends of the sides in A, C, B and D
  std::array<Phase, 2> m_beyond;     // C and D
};

} // namespace internal

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
      return surroundings.exchange();
  return std::nullopt;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_NEIGHBOR_EXCHANGE_2_H
