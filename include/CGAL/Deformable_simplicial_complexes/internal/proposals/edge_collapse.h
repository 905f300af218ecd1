// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_EDGE_COLLAPSE_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_EDGE_COLLAPSE_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Marks.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Linear_element.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/cell_corners.h>

#include <cmath>
#include <iterator>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// Comparison of the links of the two ends of an edge, in the cells, in the interface, and in the
// lines where more than two labels meet.
template <class Complex> class Collapse_test
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  using Star = std::vector<Cell_handle>;
  static constexpr int d = Complex::dimension;

  Collapse_test(const Complex& complex, Vertex_handle a, Vertex_handle b)
      : m_complex(complex), m_a(a), m_b(b) {}

  // Returns whether the removed vertex is as regular as the edge: the sectors of one label in its
  // star are exactly those around the edge. The outside of the domain counts as a label. A vertex
  // in a sheet may thus move along the sheet, and a vertex on a triple line along the line. A
  // vertex where more labels meet stays.
  bool has_same_stratum(const Star& star_a) const {
    Star around_edge;
    for (Cell_handle c : star_a)
      if (c->has_vertex(m_b))
        around_edge.push_back(c);
    const Sectors at_vertex = sectors(star_a), at_edge = sectors(around_edge);
    return at_vertex.number == at_vertex.number_at_edge && at_vertex.number == at_edge.number;
  }

  // Returns whether the intersection of Lk(a) and Lk(b) is exactly Lk(ab). The collapse then keeps
  // the topology of space. If the same holds in the walls between labels and in the lines where
  // more than two walls meet, it also keeps their topology. The outside counts as a label.
  bool fulfills_link_condition(const Star& star_a, const Star& star_b) const {
    Links volume, walls, lines;
    collect(star_a, m_a, m_b, volume.a, walls.a, lines.a);
    collect(star_b, m_b, m_a, volume.b, walls.b, lines.b);
    for (Cell_handle c : star_a) {
      if (!c->has_vertex(m_b)) {
        if (c->neighbor(c->index(m_a))->has_vertex(m_b))
          return false; // a facet is in both links
        continue;
      }
      const int ia = c->index(m_a), ib = c->index(m_b);
      std::array<std::size_t, d - 1> ring;
      auto out = ring.begin();
      for (int i = 0; i <= d; ++i)
        if (i != ia && i != ib) {
          *out = c->vertex(i)->time_stamp();
          volume.ab.push_back({*out, *out});
          if constexpr (d == 3)
            if (is_wall(c, 6 - ia - ib - i)) // opposite to the fourth vertex
              walls.ab.push_back({*out, *out});
          ++out;
        }
      if constexpr (d == 3)
        volume.ab.push_back(std::minmax(ring[0], ring[1]));
    }
    return volume.agree() && walls.agree() && lines.agree();
  }

private:
  // Vertex (v, v) or edge (v, w) of a link, given by time stamps.
  using Simplex = std::pair<std::size_t, std::size_t>;

  struct Links
  {
    std::vector<Simplex> a, b, ab;

    bool agree() {
      for (std::vector<Simplex>* link : {&a, &b, &ab}) {
        std::sort(link->begin(), link->end());
        link->erase(std::unique(link->begin(), link->end()), link->end());
      }
      std::vector<Simplex> in_both;
      std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(in_both));
      return in_both == ab;
    }
  };

  bool has_same_label(Cell_handle a, Cell_handle b) const {
    return m_complex.is_infinite(a) == m_complex.is_infinite(b) &&
           a->subdomain_index() == b->subdomain_index();
  }

  bool is_wall(Cell_handle c, int i) const { return !has_same_label(c, c->neighbor(i)); }

  // Collects the vertices and edges of the links of `center`, without `other`: in space, in the
  // walls, and in the lines.
  void collect(const Star& star, Vertex_handle center, Vertex_handle other,
               std::vector<Simplex>& volume, std::vector<Simplex>& walls,
               std::vector<Simplex>& lines) const {
    std::vector<Simplex> ends_of_walls; // one for each side of a wall
    for (Cell_handle c : star)
      for (int i = 0; i <= d; ++i) {
        if (c->vertex(i) == center)
          continue;
        // vertices of the facet opposite to i, without the center
        std::array<Vertex_handle, d - 1> ends;
        auto out = ends.begin();
        for (int j = 0; j <= d; ++j)
          if (j != i && c->vertex(j) != center)
            *out++ = c->vertex(j);
        const bool is_in_wall = is_wall(c, i);
        const auto add = [&](Simplex s) {
          volume.push_back(s);
          if (is_in_wall)
            walls.push_back(s);
        };
        for (Vertex_handle v : ends)
          if (v != other) {
            add({v->time_stamp(), v->time_stamp()});
            if (is_in_wall)
              ends_of_walls.push_back(walls.back());
          }
        if constexpr (d == 3)
          if (ends[0] != other && ends[1] != other)
            add(std::minmax(ends[0]->time_stamp(), ends[1]->time_stamp()));
      }
    std::sort(ends_of_walls.begin(), ends_of_walls.end());
    static constexpr std::ptrdiff_t sides_in_a_sheet = 4; // at an edge between two walls
    for (auto first = ends_of_walls.begin(); first != ends_of_walls.end();) {
      const auto last = std::upper_bound(first, ends_of_walls.end(), *first);
      if (last - first > sides_in_a_sheet)
        lines.push_back(*first);
      first = last;
    }
  }

  struct Sectors
  {
    std::size_t number = 0, number_at_edge = 0;
  };

  // Counts connected sets of cells of one label. Infinite cells have a label of their own.
  Sectors sectors(const Star& cells) const {
    Sectors result;
    Star front;
    Marks unseen = cell_marks(m_complex);
    for (Cell_handle c : cells)
      unseen.add(c);
    for (Cell_handle seed : cells) {
      if (!unseen.has(seed))
        continue;
      bool is_at_edge = false;
      unseen.remove(seed);
      front.push_back(seed);
      while (!front.empty()) {
        const Cell_handle c = front.back();
        front.pop_back();
        is_at_edge = is_at_edge || c->has_vertex(m_b);
        for (int i = 0; i <= d; ++i)
          if (unseen.has(c->neighbor(i)) && has_same_label(c, c->neighbor(i))) {
            unseen.remove(c->neighbor(i));
            front.push_back(c->neighbor(i));
          }
      }
      ++result.number;
      result.number_at_edge += is_at_edge;
    }
    return result;
  }

  const Complex& m_complex;
  Vertex_handle m_a, m_b;
};

} // namespace internal

template <class Complex>
bool propose_edge_collapse(const Complex& complex, typename Complex::Cell_handle cell, int i, int j,
                           double minimum_quality,
                           Deformable_simplicial_complexes::Cavity<Complex>& cavity) {
  const auto a = cell->vertex(i), b = cell->vertex(j);
  if (complex.is_infinite(a) || complex.is_infinite(b) ||
      !Boundary_class::contains(b->boundary_class(), a->boundary_class()) ||
      (a->boundary_class() & Boundary_class::fixed) != 0 ||
      (a->is_interface() && !b->is_interface()))
    return false;

  static constexpr std::size_t many = 64; // cells; most vertices have fewer
  std::vector<typename Complex::Cell_handle> star_a, star_b;
  star_a.reserve(many);
  complex.star(a, star_a);
  // Most proposals fail this test, before anything is planned.
  const bool is_good_enough = std::all_of(star_a.begin(), star_a.end(), [&](auto c) {
    if (c->has_vertex(b) || complex.is_infinite(c))
      return true;
    return complex.quality(c, [&](auto v) { return complex.position(v == a ? b : v); }) >=
           minimum_quality;
  });
  if (!is_good_enough)
    return false;

  cavity.begin(Proposal_kind::collapse);
  for (auto c : star_a)
    cavity.remove(c);
  cavity.collapse(a, b);
  const auto b_index = cavity.add(b);
  for (auto c : star_a) {
    if (c->has_vertex(b))
      continue;
    typename Deformable_simplicial_complexes::Cavity<Complex>::Indices corners;
    for (int k = 0; k < Complex::corners; ++k)
      corners[k] = c->vertex(k) == a ? b_index : cavity.add(c->vertex(k));
    cavity.create(corners, c);
  }
  if (!cavity.is_admissible())
    return false;

  const internal::Collapse_test<Complex> test(complex, a, b);
  if (!test.has_same_stratum(star_a))
    return false;
  complex.star(b, star_b);
  return test.fulfills_link_condition(star_a, star_b);
}

namespace internal {

// Returns the volume, in the plane the area, that the interface sweeps if it moves with the vertex
// a onto the vertex b.
template <class Complex>
double volume_swept_by_collapse(const Complex& complex, typename Complex::Vertex_handle a,
                                typename Complex::Vertex_handle b) {
  if (!a->is_interface())
    return 0;
  const auto from = complex.position(a), to = complex.position_near(from, b);
  std::vector<typename Complex::Cell_handle> star;
  complex.star(a, star);
  double result = 0;
  for (auto c : star)
    for (int i = 0; i < Complex::corners; ++i) {
      if (complex.is_infinite(c) || c->vertex(i) == a || complex.is_infinite(c->neighbor(i)) ||
          c->subdomain_index() <=
              c->neighbor(i)->subdomain_index()) // each facet of the interface once
        continue;
      auto corners = cell_corners(complex, c, from);
      corners[i] = to;
      result += std::abs(Linear_element<Complex>(corners).measure());
    }
  return result;
}

// Proposes to collapse an edge in one of its directions. The one in which the interface sweeps less
// has priority, so that a vertex that slides along the interface does not replace a corner.
template <class Complex>
bool propose_collapse_either_way(const Complex& complex, typename Complex::Cell_handle cell, int i,
                                 int j, double minimum_quality, Cavity<Complex>& cavity) {
  const auto a = cell->vertex(i), b = cell->vertex(j);
  if (a->is_interface() && b->is_interface() &&
      volume_swept_by_collapse(complex, b, a) < volume_swept_by_collapse(complex, a, b))
    std::swap(i, j);
  return propose_edge_collapse(complex, cell, i, j, minimum_quality, cavity) ||
         propose_edge_collapse(complex, cell, j, i, minimum_quality, cavity);
}

} // namespace internal

template <class Complex>
bool propose_degenerate_edge_removal(const Complex& complex, typename Complex::Cell_handle cell,
                                     int i, int j, double minimum_length, double minimum_quality,
                                     Deformable_simplicial_complexes::Cavity<Complex>& cavity) {
  using namespace internal;
  const auto edge = complex.displacement(cell->vertex(i), cell->vertex(j));
  return edge.squared_length() < minimum_length * minimum_length &&
         propose_collapse_either_way(complex, cell, i, j, minimum_quality, cavity);
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_EDGE_COLLAPSE_H
