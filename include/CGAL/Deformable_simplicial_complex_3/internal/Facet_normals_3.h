// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_FACET_NORMALS_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_FACET_NORMALS_3_H

#include <array>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// The outward normals of the facets of a cell, as long as twice their areas.
template <class Complex> class Facet_normals_3
{
public:
  using Vector = typename Complex::Approximate_vector_3;

  Facet_normals_3(const Complex& complex, typename Complex::Cell_handle cell) {
    for (int i = 0; i < 4; ++i) {
      const auto v = complex.facet_vertices({cell, i});
      const auto p = complex.position(v[0]);
      m_normals[i] = cross_product(complex.position(v[1]) - p, complex.position(v[2]) - p);
      if (m_normals[i].squared_length() > m_normals[m_largest].squared_length())
        m_largest = i;
    }
  }

  const Vector& operator[](int i) const { return m_normals[i]; }

  int largest() const { return m_largest; }

  // The barycentric coordinate, for a vertex i of the largest facet, of the projection of the
  // opposite vertex to that facet: the normals sum up to zero, so these do to one.
  double coordinate_of_projection(int i) const {
    return -(m_normals[i] * m_normals[m_largest]) / m_normals[m_largest].squared_length();
  }

private:
  std::array<Vector, 4> m_normals;
  int m_largest = 0;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_FACET_NORMALS_3_H
