// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Interface_remeshing, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_REMESHING_INTERNAL_INTERFACE_CURVED_MIDPOINT_3_H
#define CGAL_INTERFACE_REMESHING_INTERNAL_INTERFACE_CURVED_MIDPOINT_3_H

#include <CGAL/Deformable_simplicial_complexes/internal/interface/Interface_fan.h>
#include <CGAL/Deformable_simplicial_complexes/internal/operations/triangle_quality.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the unit normal at the center of a fan; a null vector if the facet normals cancel each
// other.
template <class Complex>
typename Complex::Approximate_vector_3 normal_of(const Interface_fan_3<Complex>& fan,
                                                 const Complex& complex) {
  using Vector = typename Complex::Approximate_vector_3;
  const auto p = complex.position(fan.center());
  Vector sum(0, 0, 0);
  for (std::size_t i = 0; i < fan.size(); ++i) {
    const auto f = fan.facet(i, p);
    const Vector area = area_vector(f);
    const double length = std::sqrt(area.squared_length());
    if (length > 0)
      sum = sum + angle_between(f[1] - p, f[2] - p) / length * area;
  }
  const double length = std::sqrt(sum.squared_length());
  return length > 0 ? sum / length : sum;
}

// Returns the midpoint of a cubic curve between the centers of two fans that is perpendicular to
// their normals (A. Vlachos and others, Curved PN triangles, I3D 2001). Used for surfaces that are
// too steep for a height function over a plane.
template <class Complex>
typename Complex::Approximate_point_3 midpoint_by_normals(const Complex& complex,
                                                          const Interface_fan_3<Complex>& a,
                                                          const Interface_fan_3<Complex>& b) {
  const auto p = complex.position(a.center()), q = complex.position_near(p, b.center());
  const auto n = normal_of(a, complex), m = normal_of(b, complex);
  return midpoint(p, q) - (((q - p) * n) * n + ((p - q) * m) * m) / 8;
}

// Returns the estimated position of the midpoint of an edge on the smooth surface that the
// interface approximates. A quadric, as a height function over the mean tangent plane of the two
// fans, is fitted to the vertices of the fans. Where a facet is inclined to that plane by more than
// 45 degrees, midpoint_by_normals() is used instead. Returns `nullopt` if there are too few
// vertices for the fit, or the facet normals cancel each other.
template <class Complex>
std::optional<typename Complex::Approximate_point_3>
curved_midpoint(const Complex& complex, const Interface_fan_3<Complex>& a,
                const Interface_fan_3<Complex>& b) {
  using Vector = typename Complex::Approximate_vector_3;
  static constexpr Eigen::Index coefficients = 6;
  static constexpr double steep_cosine = .7071;
  const auto p = complex.position(a.center()), q = complex.position_near(p, b.center());
  const auto middle = midpoint(p, q);
  Vector normal(0, 0, 0);
  std::vector<typename Complex::Vertex_handle> vertices;
  for (const Interface_fan_3<Complex>* fan : {&a, &b}) {
    for (std::size_t i = 0; i < fan->size(); ++i)
      normal = normal + area_vector(fan->facet(i, complex.position(fan->center())));
    fan->for_each_neighbor([&](auto v) { vertices.push_back(v); });
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  const Eigen::Index n = Eigen::Index(vertices.size());
  const double normal_length = std::sqrt(normal.squared_length());
  if (n <= coefficients || !(normal_length > 0))
    return std::nullopt;
  normal = normal / normal_length;
  for (const Interface_fan_3<Complex>* fan : {&a, &b})
    for (std::size_t i = 0; i < fan->size(); ++i) {
      const Vector n_i = area_vector(fan->facet(i, complex.position(fan->center())));
      if (!(n_i * normal > steep_cosine * std::sqrt(n_i.squared_length())))
        return midpoint_by_normals(complex, a, b);
    }
  Vector along = (q - p) - ((q - p) * normal) * normal;
  const double length = std::sqrt(along.squared_length());
  if (!(length > 0))
    return std::nullopt;
  along = along / length;
  const Vector across = cross_product(normal, along);

  Eigen::Matrix<double, Eigen::Dynamic, coefficients> rows(n, coefficients);
  Eigen::VectorXd heights(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Vector d = (complex.position_near(middle, vertices[std::size_t(i)]) - middle) / length;
    const double x = d * along, y = d * across;
    const double weight = 1 / (.25 + x * x + y * y); // largest at the ends of the edge
    rows.row(i) << weight, weight * x, weight * y, weight * x * x, weight * x * y, weight * y * y;
    heights(i) = weight * (d * normal);
  }
  // Limits the height, in units of the edge length: larger heights are artifacts of the fit.
  static constexpr double highest = .25;
  const double height = rows.colPivHouseholderQr().solve(heights)(0);
  return middle + length * std::clamp(height, -highest, highest) * normal;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INTERFACE_REMESHING_INTERNAL_INTERFACE_CURVED_MIDPOINT_3_H
