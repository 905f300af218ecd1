// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Solid_reconstruction_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_CLOUDS_SURFACE_POINTS_3_H
#define CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_CLOUDS_SURFACE_POINTS_3_H

#include <CGAL/Deformable_simplicial_complexes/Disjoint_sets.h>
#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/Point_cloud_3.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/local_fits_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the clusters of a point cloud: for each point, the smallest index of its cluster. Two
// points are adjacent if their distance is small compared with the distances of both from their
// sixth neighbors.
inline std::vector<std::size_t> clusters_of(const Point_cloud_3& cloud) {
  const std::vector<Point_cloud_3::Point>& points = cloud.points();
  std::vector<std::vector<std::size_t>> adjacent(points.size());
  cloud.for_each()(points.size(), [&](std::size_t i) {
    Progress_scope::check();
    for (std::size_t k : cloud.nearest(points[i], Point_cloud_3::ring + 1)) {
      const double reach = reach_of_points * (std::min)(cloud.reach(i), cloud.reach(k));
      if (k != i && (points[k] - points[i]).squared_length() <= reach * reach)
        adjacent[i].push_back(k);
    }
  });
  Disjoint_sets sets(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k : adjacent[i])
      sets.join(i, k);
  std::vector<std::size_t> result(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    result[i] = sets.find(i);
  return result;
}

// Returns the median of some values.
inline double median_of(std::vector<double> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Marks the points that lie on surfaces. The points of a cluster are outliers if there are few of
// them, or if they fill a volume. The largest cluster is a surface.
inline std::vector<char> surface_points(const Point_cloud_3& cloud) {
  static constexpr unsigned neighbors = 16; // about two rings, as for normals
  static constexpr double filled = .25;     // of the width; thinner: a layer
  static constexpr double noisy = 4;        // residuals of the largest cluster; thicker: no noise
  const std::vector<std::size_t> clusters = clusters_of(cloud);
  std::map<std::size_t, std::vector<std::size_t>> members;
  for (std::size_t i = 0; i < clusters.size(); ++i)
    members[clusters[i]].push_back(i);
  std::vector<char> result(cloud.size(), 1);
  if (members.size() == 1)
    return result;

  std::vector<Fitted_plane_3> planes(cloud.size());
  cloud.for_each()(cloud.size(), [&](std::size_t i) {
    Progress_scope::check();
    std::vector<Point_cloud_3::Point> near;
    for (std::size_t k : cloud.nearest(cloud.points()[i], neighbors + 1)) // and itself
      near.push_back(cloud.points()[k]);
    planes[i] = fit_plane(near);
  });
  const auto median = [&](const std::vector<std::size_t>& cluster, double Fitted_plane_3::*value) {
    std::vector<double> values;
    for (std::size_t i : cluster)
      values.push_back(planes[i].*value);
    return median_of(std::move(values));
  };
  const auto& largest = std::max_element(members.begin(), members.end(), [](auto& a, auto& b) {
                          return a.second.size() < b.second.size();
                        })->second;
  const double thickness = noisy * median(largest, &Fitted_plane_3::residual);
  for (const auto& [first, cluster] : members) {
    const double residual = median(cluster, &Fitted_plane_3::residual);
    const bool has_volume =
        residual > thickness && residual > filled * median(cluster, &Fitted_plane_3::width);
    if (first != largest.front() && (cluster.size() <= neighbors || has_volume))
      for (std::size_t i : cluster)
        result[i] = 0;
  }
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_CLOUDS_SURFACE_POINTS_3_H
