// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_CHANGED_FACETS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_CHANGED_FACETS_H

#include <CGAL/Deformable_simplicial_complexes/internal/interface/Interface_fan.h>
#include <CGAL/Deformable_simplicial_complexes/internal/operations/triangle_quality.h>

#include <CGAL/number_utils.h>

#include <limits>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The interface facets around an edge.
template <class Complex> class Interface_edge_3
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  using Point = typename Complex::Point_3;

  Interface_edge_3(const Complex& complex, Cell_handle cell, int i, int j)
      : m_complex(complex), m_ends{cell->vertex(i), cell->vertex(j)} {
    auto c = complex.triangulation().tds().incident_cells(cell, i, j), done = c;
    do {
      for (int k = 0; k < 4; ++k) {
        const Cell_handle d = Cell_handle(c)->neighbor(k);
        if (c->vertex(k) != m_ends[0] && c->vertex(k) != m_ends[1] && !complex.is_infinite(d) &&
            !complex.is_infinite(Cell_handle(c)) && c->subdomain_index() > d->subdomain_index())
          add(Cell_handle(c), k);
      }
    } while (++c != done);
  }

  // Returns whether exactly two facets meet at the edge, with the same labels behind and in front
  // of both.
  bool is_in_sheet() const { return m_facets.size() == 2 && m_is_between_two_labels; }

  // Returns the angle between the normals of the two facets, in radians.
  // \pre is_in_sheet()
  double bend() const { return angle_between(area_vector(m_facets[0]), area_vector(m_facets[1])); }

  // Returns whether the sum of the two angles opposite to the edge exceeds 180 degrees by more than
  // rounding errors.
  // \pre is_in_sheet()
  bool violates_delaunay_criterion() const {
    static constexpr double rounding = 1e-6;
    return opposite_angle(0) + opposite_angle(1) > CGAL_PI + rounding;
  }

  // Return the current facets, and the facets after a flip. Each starts with an end of the edge,
  // followed by the two opposite corners. The corners are ordered so that the normals of a flat
  // pair are parallel.
  // \pre is_in_sheet()
  const std::array<Point, 3>& facet(std::size_t i) const { return m_facets[i]; }
  std::array<Point, 3> flipped_facet(std::size_t i) const {
    return {end(i), m_opposite[i], m_opposite[1 - i]};
  }

private:
  void add(Cell_handle c, int k) {
    m_is_between_two_labels =
        m_is_between_two_labels &&
        (m_facets.empty() ||
         (c->subdomain_index() == m_behind && c->neighbor(k)->subdomain_index() == m_in_front));
    m_behind = c->subdomain_index();
    m_in_front = c->neighbor(k)->subdomain_index();
    const auto v = m_complex.facet_vertices({c, k});
    m_facets.push_back({seen(v[0]), seen(v[1]), seen(v[2])});
    for (Vertex_handle w : v)
      if (w != m_ends[0] && w != m_ends[1])
        m_opposite.push_back(seen(w));
  }

  double opposite_angle(std::size_t i) const {
    return angle_between(end(0) - m_opposite[i], end(1) - m_opposite[i]);
  }

  // Returns the position of a vertex, in the periodic image nearest to the first end of the edge.
  Point seen(Vertex_handle v) const {
    return m_complex.position_near(m_complex.position(m_ends[0]), v);
  }
  Point end(std::size_t i) const { return seen(m_ends[i]); }

  const Complex& m_complex;
  std::array<Vertex_handle, 2> m_ends;
  boost::container::small_vector<std::array<Point, 3>, 4> m_facets;
  boost::container::small_vector<Point, 4> m_opposite;
  typename Complex::Label m_behind = 0, m_in_front = 0;
  bool m_is_between_two_labels = true;
};

// The change of the interface facets by an operation.
struct Changed_facets
{
  double worst_before = std::numeric_limits<double>::infinity(); // quality of a facet
  double worst_after = std::numeric_limits<double>::infinity();  // 0 if a facet is inverted
  double swept_volume = 0; // volume between the interface before and after; in the plane, area
};

// Returns the change of the facets of a fan when its center is collapsed into a neighbor.
template <class Complex>
Changed_facets facets_changed_by_collapse(const Complex& complex,
                                          const Interface_fan_3<Complex>& fan,
                                          typename Complex::Vertex_handle kept) {
  const auto from = complex.position(fan.center()), to = complex.position_near(from, kept);
  Changed_facets result;
  for (std::size_t i = 0; i < fan.size(); ++i) {
    const auto before = fan.facet(i, from);
    result.worst_before = (std::min)(result.worst_before, triangle_quality(before));
    if (fan.has_neighbor(i, kept))
      continue; // the facet is removed
    const auto after = fan.facet(i, to);
    const bool turns_over = !(area_vector(before) * area_vector(after) > 0);
    result.worst_after = (std::min)(result.worst_after, turns_over ? 0 : triangle_quality(after));
    result.swept_volume += std::abs((to - from) * area_vector(before)) / 3;
  }
  return result;
}

// Returns the change of the two facets at an edge when the edge is flipped.
// \pre edge.is_in_sheet()
template <class Complex>
Changed_facets facets_changed_by_flip(const Interface_edge_3<Complex>& edge) {
  Changed_facets result;
  for (int i = 0; i < 2; ++i) {
    result.worst_before = (std::min)(result.worst_before, triangle_quality(edge.facet(i)));
    result.worst_after = (std::min)(result.worst_after, triangle_quality(edge.flipped_facet(i)));
  }
  // The two flipped facets traverse their common edge in opposite directions. The pair is folded
  // over if their normals are not on the same side.
  if (!(area_vector(edge.flipped_facet(0)) * area_vector(edge.flipped_facet(1)) > 0))
    result.worst_after = 0;
  const auto p = edge.flipped_facet(0);
  result.swept_volume = std::abs((edge.flipped_facet(1)[0] - p[0]) * area_vector(p)) / 3;
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_CHANGED_FACETS_H
