// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_CURVED_MIDPOINT_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_CURVED_MIDPOINT_3_H

#include <CGAL/Deformable_simplicial_complex_3/internal/Interface_fan_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/interface_triangles_3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Where the middle of an edge would be on the smooth surface that the interface is an image of: on
// the quadric, as a height over the mean tangent plane of the two fans, that fits their vertices
// best. Nothing if there are too few of them, or if a facet is inclined to that plane by more than
// 45 degrees: the surface has a feature there, or bends so much that there is no telling.
template <class Complex>
std::optional<typename Complex::Approximate_point_3>
curved_midpoint(const Complex& complex, const Interface_fan_3<Complex>& a,
                const Interface_fan_3<Complex>& b) {
  using Vector = typename Complex::Approximate_vector_3;
  static constexpr Eigen::Index coefficients = 6;
  static constexpr double feature_cosine = .7071;
  const auto p = complex.position(a.center()), q = complex.position(b.center());
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
      if (!(n_i * normal > feature_cosine * std::sqrt(n_i.squared_length())))
        return std::nullopt;
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
    const Vector d = (complex.position(vertices[std::size_t(i)]) - middle) / length;
    const double x = d * along, y = d * across;
    const double weight = 1 / (.25 + x * x + y * y); // that of the ends is the highest
    rows.row(i) << weight, weight * x, weight * y, weight * x * x, weight * x * y, weight * y * y;
    heights(i) = weight * (d * normal);
  }
  const double height = rows.colPivHouseholderQr().solve(heights)(0);
  return middle + length * height * normal;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_CURVED_MIDPOINT_3_H
