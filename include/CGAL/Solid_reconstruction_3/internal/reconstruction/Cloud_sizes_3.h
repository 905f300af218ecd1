// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Solid_reconstruction_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_CLOUD_SIZES_3_H
#define CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_CLOUD_SIZES_3_H

#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/Sampled_surface_3.h>
#include <CGAL/Solid_reconstruction_3/internal/reconstruction/Cloud_facets_3.h>

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The sizing field of a reconstruction. The target edge length is small where the surface is curved
// and where facets do not fit, and large away from points.
class Cloud_sizes_3
{
public:
  using Point = Sampled_surface_3::Point;
  using Vector = Sampled_surface_3::Vector;

  // \param edge the largest target edge length at points, if it is not too short for them
  // \param tolerance the largest root mean square of the distances of points from a facet, in
  //        spacings
  Cloud_sizes_3(const Sampled_surface_3& surface, double edge, double tolerance)
      : m_surface(surface), m_sizes(surface.cloud().size()) {
    static constexpr double radii = 1.2; // in radii of curvature: about 10 facets around a ball
    static constexpr double least = 4;   // in spacings; `refine()` divides facets that do not fit
    // In spacings: facets need points, and at a crease enough to tell its two sides.
    static constexpr double smooth_floor = 2, crease_floor = 3;
    // In noises: facets need enough points to average the noise, fewer where a curved surface needs
    // it.
    static constexpr double flat_noise = 24, curved_noise = 14;
    static constexpr double fits = 1.3; // in noises; facets of ten points that fit rarely have more
    const double spacing = surface.cloud().spacing(), noise = surface.noise();
    m_bound = (std::max)(tolerance * spacing, fits * noise);
    m_smooth_floor = smooth_floor * spacing + curved_noise * noise;
    m_crease_floor = crease_floor * spacing + flat_noise * noise;
    for (std::size_t i = 0; i < m_sizes.size(); ++i)
      m_sizes[i] = (std::max)(m_smooth_floor,
                              (std::min)(edge, (std::max)(least * spacing + flat_noise * noise,
                                                          radii / surface.curvature(i))));
  }

  template <class P> double operator()(const P& q) const {
    static constexpr double grading = .7; // of the distance from points
    const Point p(q.x(), q.y(), q.z());
    const std::size_t i = m_surface.cloud().nearest(p);
    return (std::max)(m_sizes[i],
                      grading * std::sqrt((m_surface.cloud().points()[i] - p).squared_length()));
  }

  // Decreases the target edge length where a facet at rest does not fit its points and the approach
  // has ended, or where a facet at rest has no points.
  void refine(const Cloud_triangles_3& triangles, const Cloud_planes_3& planes,
              const std::vector<char>& rests, bool fits) {
    static constexpr double least = .4, half = .5; // of an edge; without points
    for (std::size_t f = 0; f < triangles.size(); ++f) {
      Progress_scope::check();
      if (rests[f] == 0 || (planes[f].is_near && (!fits || planes[f].residual <= m_bound)))
        continue;
      const auto& t = triangles[f];
      double edge = 0;
      for (int k = 0; k < 3; ++k)
        edge = (std::max)(edge, std::sqrt((t[k] - t[k + 1]).squared_length()));
      // The distances of points from a facet grow with the square of its edges.
      const double part = planes[f].is_near ? std::sqrt(m_bound / planes[f].residual) : half;
      const double target = (std::max)(planes[f].has_crease ? m_crease_floor : m_smooth_floor,
                                       (std::max)(least, part) * edge);
      for (std::size_t i : planes[f].points)
        ask(i, target);
      if (planes[f].points.empty())
        ask(m_surface.cloud().nearest(CGAL::centroid(t)), target);
    }
  }

private:
  void ask(std::size_t i, double size) { m_sizes[i] = (std::min)(m_sizes[i], size); }

  const Sampled_surface_3& m_surface;
  std::vector<double> m_sizes; // target edge lengths at the points
  double m_bound, m_smooth_floor, m_crease_floor;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_CLOUD_SIZES_3_H
