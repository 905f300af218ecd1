// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_ANGLE_STATISTICS_H
#define DSC_ANGLE_STATISTICS_H

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace dsc {

/// Returns the six dihedral angles of a tetrahedron in degrees, computed from the facet normals.
/// They are finite for any corners.
template <class Point> std::array<double, 6> dihedral_angles(const std::array<Point, 4>& p) {
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

/// The dihedral angles of tetrahedra, in degrees.
struct Angle_statistics
{
  double least = 180, largest = 0;
  std::array<std::size_t, 18> histogram = {}; ///< bins of 10 degrees
  std::size_t outside = 0;                    ///< number of angles below 6 or above 171 degrees

  /// Adds the angles of a tetrahedron.
  template <class Point> void add(const std::array<Point, 4>& corners) {
    for (const double angle : dihedral_angles(corners)) {
      least = std::min(least, angle);
      largest = std::max(largest, angle);
      ++histogram[std::min<std::size_t>(17, static_cast<std::size_t>(angle / 10))];
      outside += angle < 6 || angle > 171;
    }
  }
};

} // namespace dsc

#endif // DSC_ANGLE_STATISTICS_H
