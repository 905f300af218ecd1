// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_CLOUDS_SAMPLED_SHEET_3_H
#define CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_CLOUDS_SAMPLED_SHEET_3_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/Point_cloud_3.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/cloud_properties_3.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A surface that a cloud samples and that can be open. It has no sides.
class Sampled_sheet_3
{
public:
  using Point = Point_cloud_3::Point;

  // Removes outliers, and smooths the points of a layer of noise. Throws Invalid_points_error if
  // too few points remain.
  Sampled_sheet_3(const std::vector<Point>& points, unsigned number_of_threads)
      : m_cloud(points, {}, number_of_threads) {
    static constexpr double noisy = .01; // in spacings; thicker layers are smoothed
    m_cloud.keep(surface_points(m_cloud));
    m_cloud.keep(fit());
    m_points = m_cloud.points();
    if (can_be_smoothed(m_cloud, m_noise, noisy))
      smooth();
  }

  const Point_cloud_3& cloud() const { return m_cloud; }
  // Returns the points of the surface, in the order of the cloud.
  const std::vector<Point>& points() const { return m_points; }
  // Returns the median of the residuals of quadrics that are fitted to the neighbors of each point.
  double noise() const { return m_noise; }

private:
  // Computes the noise. Returns marks of the points that are not off the planes of all neighbors.
  std::vector<char> fit() {
    static constexpr unsigned around = 16; // number of neighbors: about two rings
    const std::vector<Point>& points = m_cloud.points();
    std::vector<std::vector<std::size_t>> neighbors(points.size());
    std::vector<Fitted_plane_3> planes(points.size());
    std::vector<double> residuals(points.size());
    m_cloud.for_each()(points.size(), [&](std::size_t i) {
      Progress_scope::check();
      neighbors[i] = m_cloud.nearest(points[i], around + 1); // including the point itself
      std::vector<Point> nearby;
      for (std::size_t k : neighbors[i])
        nearby.push_back(points[k]);
      planes[i] = fit_plane(nearby);
      residuals[i] = fit_quadric(nearby, planes[i]).residual;
    });
    m_noise = median_of(residuals);
    std::vector<char> is_kept(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      is_kept[i] = !is_off_planes(m_cloud, i, neighbors[i], planes);
    return is_kept;
  }

  // Moves the points towards smoothed points. The bound of the motion preserves sharp edges.
  void smooth() {
    static constexpr double farthest = 3; // in noises
    const std::vector<Point> smoothed = smoothed_points(m_cloud, m_noise);
    for (std::size_t i = 0; i < m_points.size(); ++i) {
      const auto motion = smoothed[i] - m_points[i];
      const double part = farthest * m_noise / std::sqrt(motion.squared_length());
      m_points[i] += (std::min)(part, 1.) * motion;
    }
  }

  Point_cloud_3 m_cloud;
  std::vector<Point> m_points;
  double m_noise = 0;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_CLOUDS_SAMPLED_SHEET_3_H
