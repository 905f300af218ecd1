// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_RECONSTRUCTION_WAYS_BY_LEAST_SQUARES_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_RECONSTRUCTION_WAYS_BY_LEAST_SQUARES_H

#include <CGAL/Deformable_simplicial_complex_3/internal/reconstruction/Cloud_facets_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/reconstruction/Sampled_surface_3.h>

#include <Eigen/Sparse>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// The ways of the vertices of an interface that bring its facets nearest to the points of a cloud,
// by least squares over all of them; vertices without points go to the middle of their neighbors.
template <class Facets>
std::vector<Sampled_surface_3::Vector>
ways_by_least_squares(const Sampled_surface_3& surface, const Facets& facets,
                      const std::vector<Sampled_surface_3::Point>& positions,
                      const Cloud_triangles_3& triangles) {
  using Vector = Sampled_surface_3::Vector;
  static constexpr double stiffness = .05; // of vertices, beside points of weight 1
  static constexpr double tolerance = 1e-4;
  const Point_cloud_3& cloud = surface.cloud();
  const auto n = 3 * Eigen::Index(positions.size());
  const auto row = [&](std::size_t f, int k) {
    return 3 * Eigen::Index(facets[f].vertices[std::size_t(k)]);
  };
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  std::vector<char> has_points(positions.size(), 0);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const std::size_t f = triangles.nearest(i);
    const auto& t = triangles[f];
    const auto foot = triangles.foot(i);
    const Vector across = cross_product(t[1] - t[0], t[2] - t[0]), way = cloud.points()[i] - foot;
    const double squared = across.squared_length(), reach = reach_of_points * cloud.reach(i);
    if (!(squared > 0) || way.squared_length() > reach * reach ||
        (surface.is_oriented(i) && surface.normal(i) * across < 0))
      continue;
    const Vector normal = across / std::sqrt(squared);
    double b[3]; // barycentric coordinates of the foot
    for (int k = 0; k < 3; ++k) {
      b[k] = cross_product(t[k + 1] - foot, t[k + 2] - foot) * across / squared;
      has_points[facets[f].vertices[std::size_t(k)]] = 1;
    }
    for (int k = 0; k < 3; ++k)
      for (int a = 0; a < 3; ++a) {
        right[row(f, k) + a] += b[k] * normal[a] * (way * normal);
        for (int l = 0; l < 3; ++l)
          for (int c = 0; c < 3; ++c)
            entries.emplace_back(row(f, k) + a, row(f, l) + c, b[k] * normal[a] * b[l] * normal[c]);
      }
  }
  for (Eigen::Index i = 0; i < n; ++i)
    entries.emplace_back(i, i, stiffness);
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver(matrix);
  solver.setTolerance(tolerance);
  const Eigen::VectorXd solution = solver.solve(right);

  std::vector<Vector> sums(positions.size(), Vector(0, 0, 0));
  std::vector<int> numbers(positions.size(), 0);
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (int k = 0; k < 3; ++k)
      for (int l : {k + 1, k + 2}) {
        sums[facets[f].vertices[std::size_t(k)]] += triangles[f][l] - triangles[f][k];
        ++numbers[facets[f].vertices[std::size_t(k)]];
      }
  std::vector<Vector> result;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const Eigen::Index i = 3 * Eigen::Index(v);
    result.push_back(has_points[v] != 0 ? Vector(solution[i], solution[i + 1], solution[i + 2])
                                        : sums[v] / (std::max)(1, numbers[v]));
  }
  return result;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_RECONSTRUCTION_WAYS_BY_LEAST_SQUARES_H
