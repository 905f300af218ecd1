// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Interface_flows, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_FLOWS_INTERNAL_CURVATURE_CLOSEST_POINT_H
#define CGAL_INTERFACE_FLOWS_INTERNAL_CURVATURE_CLOSEST_POINT_H

#include <Eigen/Dense>

#include <array>
#include <cstddef>
#include <limits>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the point of a simplex that is closest to p. If the projection of p onto the plane of the
// simplex is outside, the closest point is on a face opposite to a corner with a negative
// barycentric coordinate.
template <class Complex, std::size_t n>
typename Complex::Approximate_point
closest_point(const typename Complex::Approximate_point& p,
              const std::array<typename Complex::Approximate_point, n>& corners) {
  if constexpr (n == 1)
    return corners[0];
  else {
    constexpr int edges = int(n) - 1;
    Eigen::Matrix<double, edges, edges> products;
    Eigen::Matrix<double, edges, 1> right;
    for (int i = 0; i < edges; ++i) {
      const auto edge = corners[std::size_t(i) + 1] - corners[0];
      right(i) = edge * (p - corners[0]);
      for (int j = 0; j < edges; ++j)
        products(i, j) = edge * (corners[std::size_t(j) + 1] - corners[0]);
    }
    const Eigen::Matrix<double, edges, 1> x = products.ldlt().solve(right);
    std::array<double, n> coordinates;
    coordinates[0] = 1 - x.sum();
    for (int i = 0; i < edges; ++i)
      coordinates[std::size_t(i) + 1] = x(i);
    auto inside = corners[0];
    bool is_inside = true;
    for (std::size_t i = 0; i < n; ++i) {
      is_inside = is_inside && coordinates[i] >= 0; // false for NaN of a flat simplex
      if (i > 0)
        inside = inside + coordinates[i] * (corners[i] - corners[0]);
    }
    if (is_inside)
      return inside;
    auto result = corners[0];
    double distance = std::numeric_limits<double>::infinity();
    for (std::size_t left_out = 0; left_out < n; ++left_out) {
      if (coordinates[left_out] >= 0)
        continue;
      std::array<typename Complex::Approximate_point, n - 1> face;
      for (std::size_t i = 0, j = 0; i < n; ++i)
        if (i != left_out)
          face[j++] = corners[i];
      const auto q = closest_point<Complex>(p, face);
      if (const double other = (q - p).squared_length(); other < distance) {
        distance = other;
        result = q;
      }
    }
    return result;
  }
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INTERFACE_FLOWS_INTERNAL_CURVATURE_CLOSEST_POINT_H
