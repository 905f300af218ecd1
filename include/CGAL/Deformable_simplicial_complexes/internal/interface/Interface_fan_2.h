// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_INTERFACE_FAN_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_INTERFACE_FAN_2_H

#include <CGAL/determinant.h>

#include <array>
#include <cmath>
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
        if (c->vertex(i) == v || complex.is_infinite(d) || c->label() <= d->label())
          continue;
        m_is_between_two_labels =
            m_is_between_two_labels &&
            (m_size == 0 || (c->label() == m_behind && d->label() == m_in_front));
        m_behind = c->label();
        m_in_front = d->label();
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

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_INTERFACE_FAN_2_H
