// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TRAVERSAL_LINEAR_ELEMENT_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TRAVERSAL_LINEAR_ELEMENT_H

#include <algorithm>
#include <array>

namespace CGAL::Deformable_simplicial_complexes {

// Linear finite element (P1) on a finite cell. A function is linear in the cell and given by its
// values at the corners. The basis function of a corner is 1 at this corner and 0 at the others.
// Its gradient is the inward normal of the opposite facet, as long as the measure of the facet,
// divided by `d` times the measure of the cell.
//
// The element stores normals and the measure, and does not refer to the complex. The time of each
// function is constant, and no function throws. `const` functions can be called by any number of
// threads.
//
// Complex: a deformable simplicial complex
template <class Complex> class Linear_element
{
public:
  using Vector = typename Complex::Vector;     // a vector of the complex
  static constexpr int d = Complex::dimension; // dimension, 2 or 3

  using Corners = std::array<typename Complex::Point, d + 1>; // corners of a cell

  // Constructs the element of a cell.
  // corners: positions of the corners as seen from one of them: on a torus, images next to
  //        each other
  explicit Linear_element(const Corners& corners) : m_frame(Complex::Space::frame(corners)) {}

  // Constructs the element of the cell `c` of a complex.
  // Precondition: `c` is finite.
  Linear_element(const Complex& complex, typename Complex::Cell_handle c)
      : Linear_element(corners_of(complex, c)) {}

  // Returns the signed measure, the area or the volume: positive for a positively oriented cell.
  double measure() const { return m_frame.parallelotope / factorial; }

  // Returns the gradient of the basis function of a corner, in 1 / length.
  // Precondition: The measure is not 0.
  Vector gradient(int corner) const { return m_frame.normals[corner] / -m_frame.parallelotope; }

  // Returns the gradient of the measure with respect to the position of a corner. The cell can be
  // flat.
  Vector measure_gradient(int corner) const { return m_frame.normals[corner] / -factorial; }

  // Returns the entry of the stiffness matrix for two corners: the integral over the cell of the
  // scalar product of the gradients of their basis functions.
  // Precondition: The measure is not 0.
  double stiffness(int i, int j) const {
    return m_frame.normals[i] * m_frame.normals[j] / (factorial * m_frame.parallelotope);
  }

  static constexpr int edges = d * (d + 1) / 2; // number of edges of a cell

  // Returns the place of the edge between two different corners in `evened_stiffness()`.
  static constexpr int edge(int i, int j) {
    return i < j ? j * (j - 1) / 2 + i : i * (i - 1) / 2 + j;
  }

  // Returns the entry of the stiffness matrix for each edge, with a conductivity that is the
  // inverse of the measure. Cells of all sizes then have the same weight in an extension of a
  // displacement: small cells, most of them at the interface, are deformed less, and large cells
  // more. For nearly flat cells, the measure is replaced by a small fraction of the measure of a
  // round cell, so the entries are bounded. All entries are 0 if the cell is inverted, or flat up
  // to rounding.
  std::array<double, edges> evened_stiffness() const {
    static constexpr double flattest = 5e-4, rounding = 1e-15; // of a round cell
    std::array<double, edges> result = {};
    const double round = extent();
    if (!(measure() > rounding * round))
      return result;
    const double limited = factorial * (std::max)(measure(), flattest * round);
    const double factor = 1 / (limited * limited);
    for (int j = 1; j <= d; ++j)
      for (int i = 0; i < j; ++i)
        result[edge(i, j)] = factor * (m_frame.normals[i] * m_frame.normals[j]);
    return result;
  }

  // Returns the integral of the basis function of a corner: the entry of the lumped mass matrix
  // for unit density.
  double lumped_mass() const { return measure() / (d + 1); }

  // Returns the integral of the divergence of a vector field over the cell. The cell can be flat.
  // values: the vectors at the corners
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

  // Returns the approximate measure of a round cell whose largest facet is that of this cell.
  double extent() const {
    double largest = 0;
    for (int i = 0; i <= d; ++i)
      largest = (std::max)(largest, m_frame.normals[i].squared_length());
    return Complex::Space::measure_of_extent(largest);
  }

  static constexpr double factorial = d == 3 ? 6 : 2; // d!

  // The outward normal of a facet has d - 1 times the measure of the facet as its length. The
  // parallelotope of the edges at a corner has d! times the measure of the cell.
  typename Complex::Space::Frame m_frame;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TRAVERSAL_LINEAR_ELEMENT_H
