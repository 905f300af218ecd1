// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_RIGID_COMPONENTS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_RIGID_COMPONENTS_H

#include <CGAL/Deformable_simplicial_complexes/internal/destinations/Destinations.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Work_list.h>
#include <CGAL/Mesh_support/For_each_index.h>

#include <CGAL/Origin.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Tests which connected components of the interface stay or move rigidly in a deformation, and
// therefore keep their facets.
template <class Complex> class Rigid_components
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  using Position = typename Complex::Point;

  Rigid_components(const Complex& complex, const Destinations<Complex>& destinations)
      : m_complex(complex), m_destinations(destinations) {}

  bool has_moved(Vertex_handle v) const { return v->is_interface() && m_destinations.had(v); }

  // Returns whether a cell has vertices on the interface, and none of them has moved.
  bool has_stayed(Cell_handle c) const {
    bool result = false;
    for (int i = 0; i < Complex::corners; ++i) {
      if (has_moved(c->vertex(i)))
        return false;
      result = result || c->vertex(i)->is_interface();
    }
    return result;
  }

  // Returns the cells with `is_bad(c)` whose quality is below a threshold, in the order of time
  // stamps. Cells at regions of the interface that did not move are excluded.
  template <class IsBad>
  Work_list<Cell_handle> cells_not_stayed(double threshold, const IsBad& is_bad,
                                          const For_each_index& for_each_index) const {
    return work_list_if(
        m_complex,
        [&](Cell_handle c) { return c->quality() < threshold && !has_stayed(c) && is_bad(c); },
        for_each_index);
  }

  // Returns whether all vertices of a cell are on the interface and have kept their mutual
  // distances.
  bool has_moved_as_a_whole(Cell_handle c) const {
    return number_of_rigid_vertices(c, now()) == Complex::corners;
  }

  // Returns whether the motion keeps the mutual distances of the interface vertices of a cell, of
  // which there are at least two.
  bool moves_rigidly(Cell_handle c) const { return number_of_rigid_vertices(c, at_end()) > 1; }

  // Returns whether the motion changes the distance of two interface vertices of a cell.
  bool is_distorted(Cell_handle c) const { return number_of_rigid_vertices(c, at_end()) < 0; }

  // Returns whether the motion keeps the lengths of the edges of a facet.
  bool keeps_facet(Cell_handle c, int i) const {
    for (int j = 0; j < Complex::corners; ++j)
      for (int k = 0; k < j; ++k)
        if (j != i && k != i && !are_as_far(c->vertex(j), c->vertex(k), at_end()))
          return false;
    return true;
  }

  // Returns whether the interface touched by a cell has moved rigidly. The test uses the vertices
  // of the cell or, if only one is on the interface, the interface vertices around it.
  bool touches_rigid_component(Cell_handle c) const {
    const int number = number_of_rigid_vertices(c, now());
    if (number != 1)
      return number > 1;
    int i = 0;
    while (!c->vertex(i)->is_interface())
      ++i;
    return moves_with_neighbors(c->vertex(i));
  }

private:
  // Return functions that return the current and the final position of a vertex.
  auto now() const {
    return [this](Vertex_handle v) { return m_complex.position(v); };
  }
  auto at_end() const {
    return [this](Vertex_handle v) { return m_destinations.final_position(v); };
  }

  // Returns the number of vertices of a cell on the interface if `position_of` keeps their mutual
  // distances, -1 otherwise.
  template <class Position_of>
  int number_of_rigid_vertices(Cell_handle c, const Position_of& position_of) const {
    int number = 0;
    for (int i = 0; i < Complex::corners; ++i) {
      if (!c->vertex(i)->is_interface())
        continue;
      ++number;
      for (int j = 0; j < i; ++j)
        if (c->vertex(j)->is_interface() && !are_as_far(c->vertex(i), c->vertex(j), position_of))
          return -1;
    }
    return number;
  }

  bool moves_with_neighbors(Vertex_handle v) const {
    std::vector<Cell_handle> star; // several threads can call the function
    m_complex.star(v, star);
    return std::all_of(star.begin(), star.end(), [&](Cell_handle c) {
      for (int i = 0; i < Complex::corners; ++i)
        if (c->vertex(i)->is_interface() && !are_as_far(v, c->vertex(i), now()))
          return false;
      return true;
    });
  }

  // Returns whether the distance of two vertices at `position_of` equals their distance before the
  // motion, up to a small relative tolerance and rounding of the coordinates.
  template <class Position_of>
  bool are_as_far(Vertex_handle v, Vertex_handle w, const Position_of& position_of) const {
    static constexpr double same = 1e-6, precision = 1e-15;
    const Position p = position_of(v);
    const double rounding = precision * precision * (p - CGAL::ORIGIN).squared_length();
    const auto squared_distance = [&](const Position& a, const Position& b) {
      return (a - m_complex.domain().nearest_image(a, b)).squared_length();
    };
    const double before = squared_distance(m_destinations.position_before(v),
                                           m_destinations.position_before(w)),
                 after = squared_distance(p, position_of(w));
    return std::abs(after - before) <= same * before + rounding / same;
  }

  const Complex& m_complex;
  const Destinations<Complex>& m_destinations;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_RIGID_COMPONENTS_H
