// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Solid_reconstruction_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_CLOUDS_LOCAL_FITS_3_H
#define CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_CLOUDS_LOCAL_FITS_3_H

#include <CGAL/Simple_cartesian.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Deformable_simplicial_complexes::internal {

using Cloud_kernel = Simple_cartesian<double>;

// The plane that fits points by least squares: their barycenter, the normal, and the root mean
// square of their distances.
struct Fitted_plane_3
{
  Cloud_kernel::Point_3 center;
  Cloud_kernel::Vector_3 normal; // of unit length
  double residual;
  double width, length; // standard deviations of the points along the axes of the plane

  double height(const Cloud_kernel::Point_3& p) const { return normal * (p - center); }
};

template <class Points> Fitted_plane_3 fit_plane(const Points& points) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& p : points)
    mean += Eigen::Vector3d(p.x(), p.y(), p.z());
  mean /= double(points.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const auto& p : points) {
    const Eigen::Vector3d d = Eigen::Vector3d(p.x(), p.y(), p.z()) - mean;
    covariance += d * d.transpose();
  }
  covariance /= double(points.size());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Eigen::Vector3d n = solver.eigenvectors().col(0);
  return {{mean[0], mean[1], mean[2]},
          {n[0], n[1], n[2]},
          std::sqrt((std::max)(0., solver.eigenvalues()[0])),
          std::sqrt((std::max)(0., solver.eigenvalues()[1])),
          std::sqrt((std::max)(0., solver.eigenvalues()[2]))};
}

// The graph of a quadratic function over a plane that fits points by least squares.
struct Fitted_quadric_3
{
  double residual;  // root mean square of distances, corrected for the number of unknowns
  double curvature; // largest absolute principal curvature, in the middle
  Cloud_kernel::Vector_3 normal; // at the first point, of unit length
};

template <class Points>
Fitted_quadric_3 fit_quadric(const Points& points, const Fitted_plane_3& plane) {
  static constexpr Eigen::Index unknowns = 6;
  const auto n = Eigen::Index(points.size());
  if (n <= unknowns)
    return {plane.residual, 0, plane.normal};
  const Cloud_kernel::Vector_3 axis = plane.normal.x() * plane.normal.x() < .5
                                          ? Cloud_kernel::Vector_3(1, 0, 0)
                                          : Cloud_kernel::Vector_3(0, 1, 0);
  auto u = cross_product(plane.normal, axis);
  u = u / std::sqrt(u.squared_length());
  const auto v = cross_product(plane.normal, u);
  double extent = 0;
  for (const auto& p : points)
    extent = (std::max)(extent, std::sqrt((p - plane.center).squared_length()));
  Eigen::Matrix<double, Eigen::Dynamic, unknowns> terms(n, unknowns);
  Eigen::VectorXd heights(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto d = (points[std::size_t(i)] - plane.center) / extent;
    const double x = d * u, y = d * v;
    terms.row(i) << 1, x, y, x * x, x * y, y * y;
    heights[i] = d * plane.normal;
  }
  const Eigen::VectorXd q = terms.colPivHouseholderQr().solve(heights);
  const double x = terms(0, 1), y = terms(0, 2);
  const auto normal =
      plane.normal - (q[1] + 2 * q[3] * x + q[4] * y) * u - (q[2] + q[4] * x + 2 * q[5] * y) * v;
  return {extent * (heights - terms * q).norm() / std::sqrt(double(n - unknowns)),
          (std::abs(q[3] + q[5]) + std::hypot(q[3] - q[5], q[4])) / extent,
          normal / std::sqrt(normal.squared_length())};
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_CLOUDS_LOCAL_FITS_3_H
