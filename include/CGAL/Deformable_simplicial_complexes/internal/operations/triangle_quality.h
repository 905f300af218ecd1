// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_OPERATIONS_TRIANGLE_QUALITY_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_OPERATIONS_TRIANGLE_QUALITY_H

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the normal of a triangle, towards the side from which it is counterclockwise. Its length
// is the area of the triangle.
template <class Point> auto area_vector(const std::array<Point, 3>& p) {
  return cross_product(p[1] - p[0], p[2] - p[0]) / 2;
}

// Returns the angle between two vectors, in radians. It is accurate for small angles, and 0 if a
// vector is zero.
template <class Vector> double angle_between(const Vector& a, const Vector& b) {
  return std::atan2(std::sqrt(cross_product(a, b).squared_length()), a * b);
}

// Returns the normalized ratio of the area to the sum of the squared edge lengths: 1 for an
// equilateral triangle, 0 for a degenerate one. It corresponds to the volume-length ratio of a
// tetrahedron.
template <class Point> double triangle_quality(const std::array<Point, 3>& p) {
  const auto a = p[1] - p[0], b = p[2] - p[0], c = p[2] - p[1];
  const double squares = a.squared_length() + b.squared_length() + c.squared_length();
  const double doubled_area = std::sqrt(cross_product(a, b).squared_length());
  return squares > 0 ? 2 * std::sqrt(3.) * doubled_area / squares : 0;
}

// Returns the cosine of the smallest angle of a triangle; 1 if an edge has length zero.
template <class Point> double largest_cosine(const std::array<Point, 3>& p) {
  double result = -1;
  for (int i = 0; i < 3; ++i) {
    const auto a = p[(i + 1) % 3] - p[i], b = p[(i + 2) % 3] - p[i];
    const double lengths = std::sqrt(a.squared_length() * b.squared_length());
    result = (std::max)(result, lengths > 0 ? a * b / lengths : 1);
  }
  return result;
}

// Returns the smallest angle of a triangle, in radians; 0 if an edge has length zero.
template <class Point> double smallest_angle(const std::array<Point, 3>& p) {
  double result = 4; // greater than any angle
  for (int i = 0; i < 3; ++i)
    result = (std::min)(result, angle_between(p[(i + 1) % 3] - p[i], p[(i + 2) % 3] - p[i]));
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_OPERATIONS_TRIANGLE_QUALITY_H
