// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_ANGLE_STATISTICS_H
#define DSC_ANGLE_STATISTICS_H

#include "output/statistics.h"

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>

namespace dsc {

/// Returns the six dihedral angles of a tetrahedron in degrees, computed from the facet normals.
/// They are finite for any corners.
template <class Point> std::array<double, 6> angles_of(const std::array<Point, 4>& p) {
  static constexpr double degree = CGAL_PI / 180;
  const auto normal = [&](int i, int j, int k) {
    return CGAL::cross_product(p[j] - p[i], p[k] - p[i]);
  };
  const std::array<decltype(p[1] - p[0]), 4> n = {normal(1, 3, 2), normal(0, 2, 3), normal(0, 3, 1),
                                                  normal(0, 1, 2)};
  std::array<double, 6> angles;
  auto angle = angles.begin();
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) {
      const double sine = std::sqrt(CGAL::cross_product(n[i], n[j]).squared_length());
      *angle++ = std::atan2(sine, -(n[i] * n[j])) / degree;
    }
  return angles;
}

/// Returns the angles of a triangle in degrees.
template <class Point> std::array<double, 3> angles_of(const std::array<Point, 3>& p) {
  std::array<double, 3> angles;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto a = p[(i + 1) % 3] - p[i], b = p[(i + 2) % 3] - p[i];
    angles[i] = std::atan2(CGAL::determinant(a, b), a * b) * (180 / CGAL_PI);
  }
  return angles;
}

/// The angles of triangles or the dihedral angles of tetrahedra, in degrees.
struct Angle_statistics
{
  double least = 180, largest = 0;
  std::array<std::size_t, 18> histogram = {}; ///< bins of 10 degrees
  std::size_t outside = 0;                    ///< number of angles below 6 or above 171 degrees

  /// Adds the angles of a cell.
  template <class Corners> void add(const Corners& corners) {
    for (const double angle : angles_of(corners)) {
      least = (std::min)(least, angle);
      largest = (std::max)(largest, angle);
      ++histogram[std::size_t(std::clamp(int(angle / 10), 0, 17))];
      outside += angle < 6 || angle > 171;
    }
  }
};

/// Returns the least quality of a cell, by the measure of the complex.
template <class Complex> double least_quality(const Complex& complex) {
  double result = 1;
  for (const typename Complex::Cell_handle c : complex.finite_cells())
    result = (std::min)(result, complex.quality(c));
  return result;
}

/// Sets the angles of the statistics of a complex.
template <class Complex> void set_angles(const Complex& complex, Statistics& statistics) {
  static constexpr int corners = Complex::dimension + 1;
  Angle_statistics angles;
  for (const typename Complex::Cell_handle c : complex.finite_cells()) {
    std::array<typename Complex::Point, corners> p;
    for (int i = 0; i < corners; ++i)
      p[std::size_t(i)] = complex.position(c->vertex(i));
    angles.add(p);
  }
  statistics.min_angle = angles.least;
  statistics.max_angle = angles.largest;
  statistics.angle_histogram = angles.histogram;
  statistics.angles_outside_6_171 =
      double(angles.outside) / (corners * (corners - 1) / 2 * double(complex.number_of_cells()));
}

} // namespace dsc

#endif // DSC_ANGLE_STATISTICS_H
