// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_LINEAR_ELEMENT_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_LINEAR_ELEMENT_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <algorithm>
#include <array>

namespace CGAL {
namespace Deformable_simplicial_complexes {

// A finite cell as a linear finite element (P1): functions are given by their values at its corners
// and linear between them. The function that is 1 at one corner and 0 at the others falls off
// towards the opposite facet, so that its gradient is the inward normal of that facet over d times
// what the cell measures.
template <class Complex> class Linear_element
{
public:
  using Vector = typename Complex::Approximate_vector;
  static constexpr int d = Complex::dimension;

  using Corners = std::array<typename Complex::Approximate_point, d + 1>;

  explicit Linear_element(const Corners& corners) : m_frame(Complex::Space::frame(corners)) {}

  Linear_element(const Complex& complex, typename Complex::Cell_handle c)
      : Linear_element(corners_of(complex, c)) {}

  // Area or volume.
  double measure() const { return m_frame.parallelotope / factorial; }

  // Of the function that is 1 at a corner.
  Vector gradient(int corner) const { return m_frame.normals[corner] / -m_frame.parallelotope; }

  // By how much the measure changes when a corner moves. Also where the cell is flat.
  Vector measure_gradient(int corner) const { return m_frame.normals[corner] / -factorial; }

  // The integral of the product of two gradients.
  double stiffness(int i, int j) const {
    return m_frame.normals[i] * m_frame.normals[j] / (factorial * m_frame.parallelotope);
  }

  // What the stiffness of a corner with each is times a conductivity that is inverse to the
  // measure, so that cells of all sizes count alike. That is limited for cells that are flat, so
  // that none rules the others, and 0 if it is up to rounding only that they are not.
  std::array<double, d + 1> evened_stiffness(int corner) const {
    static constexpr double flattest = 5e-4, rounding = 1e-15; // of a round cell
    std::array<double, d + 1> result = {};
    const double round = extent();
    if (!(measure() > rounding * round))
      return result;
    const double limited = factorial * (std::max)(measure(), flattest * round);
    const double factor = 1 / (limited * limited);
    for (int j = 0; j <= d; ++j)
      result[j] = factor * (m_frame.normals[corner] * m_frame.normals[j]);
    return result;
  }

  // The integral of the function that is 1 at a corner: the part of the mass that a vertex carries.
  double lumped_mass() const { return measure() / (d + 1); }

  // The divergence of a vector field, times the measure.
  double divergence(const std::array<Vector, d + 1>& values) const {
    double result = 0;
    for (int i = 0; i <= d; ++i)
      result -= m_frame.normals[i] * values[i];
    return result / factorial;
  }

private:
  static Corners corners_of(const Complex& complex, typename Complex::Cell_handle c) {
    Corners result;
    for (int i = 0; i <= d; ++i)
      result[i] = complex.corner(c, i);
    return result;
  }

  // About what a cell with such facets would measure if it were round.
  double extent() const {
    double largest = 0;
    for (int i = 0; i <= d; ++i)
      largest = (std::max)(largest, m_frame.normals[i].squared_length());
    return Complex::Space::measure_of_extent(largest);
  }

  static constexpr double factorial = d == 3 ? 6 : 2; // of d

  // Each normal is d - 1 times as long as its facet measures, and the parallelotope of the edges at
  // a corner measures d! times the cell, which measures height times facet over d.
  typename Complex::Space::Frame m_frame;
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_LINEAR_ELEMENT_H
