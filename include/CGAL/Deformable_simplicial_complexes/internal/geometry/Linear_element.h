// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_GEOMETRY_LINEAR_ELEMENT_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_GEOMETRY_LINEAR_ELEMENT_H

#include <CGAL/Deformable_simplicial_complexes/internal/geometry/Facet_normals.h>

#include <algorithm>
#include <array>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// A finite cell as a linear finite element (P1): functions are given by their values at its corners
// and linear between them. The function that is 1 at one corner and 0 at the others falls off
// towards the opposite facet, so that its gradient is the inward normal of that facet over d times
// what the cell measures.
template <class Complex> class Linear_element
{
public:
  using Vector = typename Complex::Approximate_vector;
  static constexpr int d = Complex::dimension;

  Linear_element(const Complex& complex, typename Complex::Cell_handle c)
      : m_normals(complex, c), m_measure(complex.measure(c)) {}

  // Area or volume.
  double measure() const { return m_measure; }

  // Of the function that is 1 at a corner.
  Vector gradient(int corner) const { return m_normals[corner] / (-normal_units() * m_measure); }

  // The integral of the product of two gradients.
  double stiffness(int i, int j) const {
    return m_normals[i] * m_normals[j] / (normal_units() * normal_units() * m_measure);
  }

  // Whether gradients and stiffness mean anything: not if the cell, though positive, is flat up to
  // rounding.
  bool is_regular() const {
    static constexpr double rounding = 1e-15;
    double largest = 0;
    for (int i = 0; i <= d; ++i)
      largest = (std::max)(largest, m_normals[i].squared_length());
    return m_measure > rounding * Complex::Space::measure_of_extent(largest);
  }

  // The integral of the function that is 1 at a corner: the part of the mass that a vertex carries.
  double lumped_mass() const { return m_measure / (d + 1); }

  // The divergence of a vector field, times the measure.
  double divergence(const std::array<Vector, d + 1>& values) const {
    double result = 0;
    for (int i = 0; i <= d; ++i)
      result -= m_normals[i] * values[i] / normal_units();
    return result;
  }

private:
  // A normal is d - 1 times as long as its facet measures, and the cell measures height times facet
  // over d.
  static constexpr double normal_units() { return d * (d - 1); }

  Facet_normals<Complex> m_normals;
  double m_measure;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_GEOMETRY_LINEAR_ELEMENT_H
