// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_OPERATIONS_FACET_NORMALS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_OPERATIONS_FACET_NORMALS_H

#include <array>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The outward normals of the facets of a cell. The length of a normal is d - 1 times the measure of
// its facet.
template <class Complex> class Facet_normals
{
public:
  using Vector = typename Complex::Approximate_vector;

  Facet_normals(const Complex& complex, typename Complex::Cell_handle cell) {
    using Space = typename Complex::Space;
    for (int i = 0; i < Complex::corners; ++i) {
      std::array<typename Complex::Approximate_point, Complex::dimension> points;
      for (int k = 0; k < Complex::dimension; ++k)
        points[k] = complex.corner(cell, Space::facet_vertices[i][k]);
      m_normals[i] = Space::facet_normal(points);
      if (m_normals[i].squared_length() > m_normals[m_largest].squared_length())
        m_largest = i;
    }
  }

  const Vector& operator[](int i) const { return m_normals[i]; }

  int largest() const { return m_largest; }

  // Returns a barycentric coordinate of the projection of the opposite vertex onto a facet: the one
  // for vertex i of the cell. The sum of all normals is zero, so the coordinates sum up to 1.
  double coordinate_of_projection(int facet, int i) const {
    return -(m_normals[i] * m_normals[facet]) / m_normals[facet].squared_length();
  }

private:
  std::array<Vector, Complex::corners> m_normals;
  int m_largest = 0;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_OPERATIONS_FACET_NORMALS_H
