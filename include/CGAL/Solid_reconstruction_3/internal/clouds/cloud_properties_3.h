// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_CLOUDS_CLOUD_PROPERTIES_3_H
#define CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_CLOUDS_CLOUD_PROPERTIES_3_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/internal/sets/Disjoint_sets.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/Point_cloud_3.h>

#include <map>

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
    std::vector<Point_cloud_3::Point> nearby;
    for (std::size_t k : cloud.nearest(cloud.points()[i], neighbors + 1)) // and itself
      nearby.push_back(cloud.points()[k]);
    planes[i] = fit_plane(nearby);
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

// Returns whether a point is off the planes of all its neighbors.
inline bool is_off_planes(const Point_cloud_3& cloud, std::size_t i,
                          const std::vector<std::size_t>& neighbors,
                          const std::vector<Fitted_plane_3>& planes) {
  static constexpr double off_plane = 3; // in residuals; at least a spacing
  return std::all_of(neighbors.begin(), neighbors.end(), [&](std::size_t k) {
    return std::abs(planes[k].height(cloud.points()[i])) >
           (std::max)(cloud.spacing(), off_plane * planes[k].residual);
  });
}

// Returns whether a point lies on the boundary of the surface that a cloud samples: there is a wide
// sector without neighbors.
inline bool is_boundary_point(const Point_cloud_3& cloud, std::size_t i) {
  static constexpr unsigned around = 16;            // neighbors: about two rings
  static constexpr double widest = 2 * CGAL_PI / 3; // sector between random neighbors
  std::vector<Point_cloud_3::Point> nearby;
  for (std::size_t k : cloud.nearest(cloud.points()[i], around + 1)) // including the point itself
    nearby.push_back(cloud.points()[k]);
  const auto normal = fit_plane(nearby).normal;
  const auto first = nearby[1] - nearby[0], u = first - (first * normal) * normal,
             v = cross_product(normal, u);
  std::vector<double> angles;
  for (std::size_t k = 1; k < nearby.size(); ++k)
    angles.push_back(std::atan2((nearby[k] - nearby[0]) * v, (nearby[k] - nearby[0]) * u));
  std::sort(angles.begin(), angles.end());
  double sector = angles.front() + 2 * CGAL_PI - angles.back();
  for (std::size_t k = 1; k < angles.size(); ++k)
    sector = (std::max)(sector, angles[k] - angles[k - 1]);
  return sector > widest;
}

// Returns the number of neighbors over which a layer of noise is smoothed.
inline unsigned neighbors_to_smooth(const Point_cloud_3& cloud, double noise) {
  static constexpr double around = 24, most = 200; // points: at thickness 1; bound
  static constexpr double thickness = .25;         // in spacings
  const double layer = (std::max)(1., noise / (thickness * cloud.spacing()));
  return unsigned((std::min)(most, around * layer * layer));
}

// Returns whether points have more noise than `least`, in spacings, and are enough to be smoothed.
inline bool can_be_smoothed(const Point_cloud_3& cloud, double noise, double least) {
  static constexpr unsigned few = 10; // smallest ratio of all points to smoothed ones
  return noise > least * cloud.spacing() && cloud.size() > few * neighbors_to_smooth(cloud, noise);
}

// Returns the points of a layer of noise, projected to the surface of their cluster.
inline std::vector<Point_cloud_3::Point> smoothed_points(const Point_cloud_3& cloud, double noise) {
  static constexpr int rounds = 3;
  const std::vector<std::size_t> clusters = clusters_of(cloud);
  std::vector<Point_cloud_3::Point> points = cloud.points(), feet(points.size());
  for (int i = 0; i < rounds; ++i) {
    cloud.for_each()(points.size(), [&](std::size_t k) {
      Progress_scope::check();
      std::vector<Point_cloud_3::Point> nearby;
      for (std::size_t n : cloud.nearest(cloud.points()[k], neighbors_to_smooth(cloud, noise)))
        if (clusters[n] == clusters[k])
          nearby.push_back(points[n]); // the point itself comes first
      feet[k] = fit_quadric(nearby, fit_plane(nearby)).foot;
    });
    points.swap(feet);
  }
  return points;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_CLOUDS_CLOUD_PROPERTIES_3_H
