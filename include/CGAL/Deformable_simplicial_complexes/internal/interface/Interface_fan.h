// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_INTERFACE_FAN_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_INTERFACE_FAN_H

#include <CGAL/Deformable_simplicial_complexes/internal/operations/triangle_quality.h>

#include <CGAL/determinant.h>

#include <boost/container/small_vector.hpp>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the angle between the directions of two vectors, in radians; 0 if one of them is a null
// vector.
template <class Vector> double turn_between(const Vector& a, const Vector& b) {
  return std::abs(std::atan2(determinant(a, b), a * b));
}

// The interface edges around a vertex.
template <class Complex> class Interface_fan_2
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;

  // \pre `star` is the star of v
  Interface_fan_2(const Complex& complex, Vertex_handle v, const std::vector<Cell_handle>& star)
      : m_complex(complex), m_center(v) {
    for (Cell_handle c : star) {
      if (complex.is_infinite(c))
        continue;
      for (int i = 0; i < 3; ++i) {
        const Cell_handle d = c->neighbor(i);
        if (c->vertex(i) == v || complex.is_infinite(d) ||
            c->subdomain_index() <= d->subdomain_index())
          continue;
        m_is_between_two_labels =
            m_is_between_two_labels && (m_size == 0 || (c->subdomain_index() == m_behind &&
                                                        d->subdomain_index() == m_in_front));
        m_behind = c->subdomain_index();
        m_in_front = d->subdomain_index();
        // Each interface edge has the larger label on its left: one edge ends at the center, the
        // other one starts there.
        m_neighbors[c->vertex((i + 1) % 3) == v] = c->vertex(3 - i - c->index(v));
        ++m_size;
      }
    }
  }

  Vertex_handle center() const { return m_center; }

  // Returns the previous and the next neighbor along the interface. The larger label is on the left
  // of the direction from the first to the last one.
  // \pre is_disk()
  const std::array<Vertex_handle, 2>& neighbors() const { return m_neighbors; }

  bool is_disk() const {
    return m_size == 2 && m_is_between_two_labels && m_neighbors[0] != Vertex_handle() &&
           m_neighbors[1] != Vertex_handle();
  }

  int rank_by_features(double angle) const {
    return turn_between(m_complex.displacement(m_neighbors[0], m_center),
                        m_complex.displacement(m_center, m_neighbors[1])) > angle
               ? 2
               : 1;
  }

  bool keeps_features(double angle, Vertex_handle) const { return rank_by_features(angle) == 1; }

private:
  const Complex& m_complex;
  Vertex_handle m_center;
  std::array<Vertex_handle, 2> m_neighbors;
  int m_size = 0;
  typename Complex::Label m_behind = 0, m_in_front = 0;
  bool m_is_between_two_labels = true;
};

// The interface facets around a vertex.
template <class Complex> class Interface_fan_3
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  using Point = typename Complex::Point_3;

  // \pre `star` is the star of v
  Interface_fan_3(const Complex& complex, Vertex_handle v, const std::vector<Cell_handle>& star)
      : m_complex(complex), m_center(v) {
    for (Cell_handle c : star) {
      if (complex.is_infinite(c))
        continue;
      for (int i = 0; i < 4; ++i) {
        const Cell_handle d = c->neighbor(i);
        if (c->vertex(i) == v || complex.is_infinite(d) ||
            c->subdomain_index() <= d->subdomain_index())
          continue;
        const auto w = complex.facet_vertices({c, i});
        const std::size_t k = std::find(w.begin(), w.end(), v) - w.begin();
        m_facets.push_back({w[(k + 1) % 3], w[(k + 2) % 3]});
        m_is_between_two_labels = m_is_between_two_labels &&
                                  (m_facets.size() == 1 || (c->subdomain_index() == m_behind &&
                                                            d->subdomain_index() == m_in_front));
        m_behind = c->subdomain_index();
        m_in_front = d->subdomain_index();
      }
    }
  }

  Vertex_handle center() const { return m_center; }
  std::size_t size() const { return m_facets.size(); }

  // Calls a function for the neighbor that follows the center in each facet. If the fan is a disk,
  // these are all neighbors.
  template <class Function> void for_each_neighbor(const Function& function) const {
    for (const auto& facet : m_facets)
      function(facet[0]);
  }

  bool has_neighbor(std::size_t i, Vertex_handle v) const {
    return m_facets[i][0] == v || m_facets[i][1] == v;
  }

  // Returns facet i with the center at p. The corners are counterclockwise seen from the front,
  // starting with p.
  std::array<Point, 3> facet(std::size_t i, const Point& p) const {
    return {p, m_complex.position_near(p, m_facets[i][0]),
            m_complex.position_near(p, m_facets[i][1])};
  }

  // Returns whether the interface at the center is a single sheet between the same two labels that
  // does not end at the boundary of the domain.
  bool is_disk() const {
    if (!m_is_between_two_labels || m_facets.empty())
      return false;
    Vertex_handle w = m_facets[0][0];
    for (std::size_t steps = 1; steps <= size(); ++steps) {
      const auto next = std::find_if(m_facets.begin(), m_facets.end(),
                                     [&](const auto& facet) { return facet[0] == w; });
      if (next == m_facets.end())
        return false;
      w = (*next)[1];
      if (w == m_facets[0][0])
        return steps == size();
    }
    return false;
  }

  // Returns the neighbors that share a feature edge with the center: the two facets at the edge
  // differ by more than `angle`, in radians.
  // \pre is_disk()
  std::vector<Vertex_handle> neighbors_along_features(double angle) const {
    std::vector<Vertex_handle> result;
    const Point p = m_complex.position(m_center);
    for (std::size_t i = 0; i < size(); ++i)
      for (std::size_t j = 0; j < size(); ++j)
        if (m_facets[i][1] == m_facets[j][0] &&
            angle_between(area_vector(facet(i, p)), area_vector(facet(j, p))) > angle)
          result.push_back(m_facets[j][0]);
    return result;
  }

  // Returns the number of directions in which features constrain the center: 1 in a smooth sheet, 2
  // on a feature that turns by less than `angle`, 3 where features end, meet or turn.
  // \pre is_disk()
  int rank_by_features(double angle) const {
    const auto neighbors = neighbors_along_features(angle);
    if (neighbors.empty())
      return 1;
    const bool goes_on = neighbors.size() == 2 &&
                         angle_between(m_complex.displacement(m_center, neighbors[0]),
                                       -m_complex.displacement(m_center, neighbors[1])) < angle;
    return goes_on ? 2 : 3;
  }

  // Returns whether the features are kept when the center is moved to its neighbor w: the center is
  // in a smooth sheet, or it moves along a straight feature.
  // \pre is_disk()
  bool keeps_features(double angle, Vertex_handle w) const {
    const int rank = rank_by_features(angle);
    const auto neighbors = neighbors_along_features(angle);
    return rank == 1 || (rank == 2 && (w == neighbors[0] || w == neighbors[1]));
  }

private:
  const Complex& m_complex;
  Vertex_handle m_center;
  boost::container::small_vector<std::array<Vertex_handle, 2>, 10> m_facets;
  typename Complex::Label m_behind = 0, m_in_front = 0;
  bool m_is_between_two_labels = true;
};

/*
The interface facets at a vertex, the center of the fan. In each dimension:

- `Interface_fan(complex, v, star)`, with the star of v
- `center()`
- `is_disk()`: whether the interface at the center is a single sheet between the same two labels
  that does not end at the boundary of the domain
- `rank_by_features(angle)`: the number of directions in which features constrain the center; facets
  that differ by more than `angle`, in radians, form a feature. The rank is 1 in a smooth sheet, and
  the dimension at a corner. Precondition: is_disk()
- `keeps_features(angle, w)`: whether the features are kept when the center is moved to its neighbor
  w. Precondition: is_disk()
*/
template <class Complex>
using Interface_fan =
    std::conditional_t<Complex::dimension == 2, Interface_fan_2<Complex>, Interface_fan_3<Complex>>;

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_INTERFACE_FAN_H
