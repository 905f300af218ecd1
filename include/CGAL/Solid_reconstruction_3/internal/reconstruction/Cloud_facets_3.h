// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_CLOUD_FACETS_3_H
#define CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_CLOUD_FACETS_3_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/internal/cgal/cgal_compat.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/Sampled_surface_3.h>

#include <CGAL/Kernel/global_functions.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

template <class Points> std::vector<Sampled_surface_3::Point> cloud_points(const Points& points) {
  std::vector<Sampled_surface_3::Point> result;
  for (const auto& p : points)
    result.emplace_back(p.x(), p.y(), p.z());
  return result;
}

// The triangles of an interface, and the nearest triangle of each point of a cloud.
class Cloud_triangles_3
{
public:
  using Point = Sampled_surface_3::Point;
  using Vector = Sampled_surface_3::Vector;
  using Triangle = Cloud_kernel::Triangle_3;

  Cloud_triangles_3(const Point_cloud_3& cloud, std::vector<Triangle> triangles)
      : m_triangles(std::move(triangles)) {
    if (m_triangles.empty())
      return;
    Tree tree(m_triangles.begin(), m_triangles.end());
    tree.build(); // before threads query the tree
    tree.accelerate_distance_queries();
    m_feet.resize(cloud.size());
    m_nearest.resize(cloud.size());
    cloud.for_each()(cloud.size(), [&](std::size_t i) {
      Progress_scope::check();
      const auto found = tree.closest_point_and_primitive(cloud.points()[i]);
      m_feet[i] = found.first;
      m_nearest[i] = std::size_t(found.second - m_triangles.begin());
    });
  }

  // Returns the root mean square of the distances of points.
  double residual(const Point_cloud_3& cloud) const {
    double sum = 0;
    for (std::size_t i = 0; i < m_feet.size(); ++i)
      sum += (m_feet[i] - cloud.points()[i]).squared_length();
    return std::sqrt(sum / double(m_feet.size()));
  }

  const Triangle& operator[](std::size_t f) const { return m_triangles[f]; }
  std::size_t size() const { return m_triangles.size(); }
  const std::vector<Triangle>& all() const { return m_triangles; }
  // Returns the nearest triangle of a point, and the nearest point in it.
  std::size_t nearest(std::size_t i) const { return m_nearest[i]; }
  const Point& foot(std::size_t i) const { return m_feet[i]; }

private:
  using Triangles = std::vector<Triangle>;
  using Tree = AABB_tree<Tree_traits_3<Cloud_kernel, Triangles::const_iterator>>;

  Triangles m_triangles;
  std::vector<Point> m_feet;
  std::vector<std::size_t> m_nearest;
};

// The points that are nearest to a facet of an interface, and their plane.
struct Cloud_facet_3
{
  std::vector<std::size_t> points; // near points that do not face away
  Cloud_kernel::Point_3 center;    // of the points of the plane
  Cloud_kernel::Vector_3 normal;   // outward normal of the plane
  bool touches = false;            // whether there is a plane
  bool is_near = false;            // whether there are points
  bool has_crease = false;         // whether some points have other planes
  double residual = 0;             // root mean square of the distances of all points
};

// The planes of the facets. A facet takes the plane of the largest group of its points with similar
// normals.
class Cloud_planes_3
{
public:
  Cloud_planes_3(const Sampled_surface_3& surface, const Cloud_triangles_3& triangles)
      : m_surface(surface), m_facets(triangles.size()), m_distances(surface.cloud().size()) {
    const auto& points = surface.cloud().points();
    for (std::size_t i = 0; i < points.size(); ++i) {
      m_distances[i] = std::sqrt((triangles.foot(i) - points[i]).squared_length());
      m_facets[triangles.nearest(i)].points.push_back(i);
    }
    surface.cloud().for_each()(m_facets.size(), [&](std::size_t f) {
      Progress_scope::check();
      const Cloud_kernel::Triangle_3& t = triangles[f];
      const auto across = cross_product(t[1] - t[0], t[2] - t[0]);
      const double twice_area = std::sqrt(across.squared_length());
      if (!(twice_area > 0))
        return;
      choose_points(m_facets[f], t, across / twice_area, std::sqrt(twice_area));
      choose_plane(m_facets[f], across / twice_area);
    });
  }

  const Cloud_facet_3& operator[](std::size_t f) const { return m_facets[f]; }

private:
  using Vector = Sampled_surface_3::Vector;

  void choose_points(Cloud_facet_3& facet, const Cloud_kernel::Triangle_3& t, const Vector& normal,
                     double edge) {
    static constexpr double part = .3;  // in edges; bound on distances if others are near
    static constexpr double away = -.3; // cosine; points with a smaller one face away
    static constexpr unsigned some = 4;
    const Point_cloud_3& cloud = m_surface.cloud();
    const auto faces_away = [&](std::size_t i) {
      return m_surface.is_oriented(i) && m_surface.normal(i) * normal < away;
    };
    const auto touches = [&](std::size_t i, double distance) {
      return distance < reach_of_points * cloud.reach(i);
    };
    std::vector<std::pair<std::size_t, double>> points; // with their distances
    for (std::size_t i : facet.points)
      if (!faces_away(i)) {
        points.emplace_back(i, m_distances[i]);
        facet.is_near = facet.is_near || touches(i, m_distances[i]);
      }
    if (!facet.is_near) {
      // A small facet may have no points of its own. It uses the points around it.
      points.clear();
      for (std::size_t i : cloud.nearest(CGAL::centroid(t), some)) {
        const double distance = std::sqrt(CGAL::squared_distance(cloud.points()[i], t));
        if (touches(i, distance) && !faces_away(i))
          points.emplace_back(i, distance);
      }
      facet.is_near = !points.empty();
    }
    facet.points.clear();
    double squares = 0;
    for (const auto& [i, distance] : points)
      if (touches(i, distance) || distance <= part * edge) {
        facet.points.push_back(i);
        squares += distance * distance;
      }
    if (facet.is_near)
      facet.residual = std::sqrt(squares / double(facet.points.size()));
  }

  void choose_plane(Cloud_facet_3& facet, const Vector& normal) const {
    static const double similar = std::cos(25 * CGAL_PI / 180),
                        along = std::cos(60 * CGAL_PI / 180);
    static constexpr std::size_t most_seeds = 32; // largest number of groups that are tried
    const auto& points = facet.points;
    const std::size_t step = 1 + points.size() / most_seeds;
    std::size_t largest = 0;
    Vector best;
    for (std::size_t s = 0; s < points.size(); s += step) {
      const Vector& seed = m_surface.normal(points[s]);
      if (std::abs(seed * normal) < along)
        continue;
      std::size_t size = 0;
      for (std::size_t i : points)
        size += std::abs(m_surface.normal(i) * seed) > similar;
      if (size > largest) {
        largest = size;
        best = seed;
      }
    }
    if (largest == 0)
      return;
    Vector sum(0, 0, 0), places(0, 0, 0);
    for (std::size_t i : points) {
      const Vector& n = m_surface.normal(i);
      if (std::abs(n * best) <= similar)
        continue;
      sum = sum + (n * normal < 0 ? -1. : 1.) * n;
      places = places + (m_surface.cloud().points()[i] - CGAL::ORIGIN);
    }
    facet.touches = true;
    facet.has_crease = largest < points.size();
    facet.normal = sum / std::sqrt(sum.squared_length());
    facet.center = CGAL::ORIGIN + places / double(largest);
  }

  const Sampled_surface_3& m_surface;
  std::vector<Cloud_facet_3> m_facets;
  std::vector<double> m_distances; // of points from their facets
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_CLOUD_FACETS_3_H
