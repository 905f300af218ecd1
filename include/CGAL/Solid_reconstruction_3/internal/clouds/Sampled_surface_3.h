// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_CLOUDS_SAMPLED_SURFACE_3_H
#define CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_CLOUDS_SAMPLED_SURFACE_3_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/internal/cgal/cgal_compat.h>
#include <CGAL/Solid_reconstruction_3/Invalid_points_error.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/Cloud_sides_3.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/Point_cloud_3.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/cloud_properties_3.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Origin.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The holes of a point cloud: Delaunay facets between the inside and the outside with an edge that
// is long compared with the distances of its points from their sixth neighbors.
class Cloud_holes_3
{
public:
  explicit Cloud_holes_3(const std::vector<Cloud_sides_3::Boundary_facet>& boundary) {
    static constexpr double longest = 3; // reaches; longer than gaps of random points
    double whole = 0, open = 0;          // areas
    for (const auto& facet : boundary) {
      const Triangle t(point(facet.points[0]), point(facet.points[1]), point(facet.points[2]));
      const double area = std::sqrt(t.squared_area()), bound = longest * facet.reach;
      double edge = 0; // squared length of the longest edge
      for (int k = 0; k < 3; ++k)
        edge = (std::max)(edge, (t[k] - t[k + 1]).squared_length());
      whole += area;
      if (!(edge > bound * bound) || !(area > 0))
        continue;
      open += area;
      m_triangles.push_back(t);
    }
    m_share = whole > 0 ? open / whole : 0;
    m_tree.insert(m_triangles.cbegin(), m_triangles.cend());
    m_tree.build();
    if (!m_triangles.empty())
      m_tree.accelerate_distance_queries(); // before threads query the tree
  }

  Cloud_holes_3(const Cloud_holes_3&) = delete; // the tree refers to the triangles
  Cloud_holes_3& operator=(const Cloud_holes_3&) = delete;

  // Returns the part of the boundary of the inside that has no points, by area.
  double share() const { return m_share; }
  bool meets(const Cloud_sides_3::Ball& ball) const {
    return !m_triangles.empty() &&
           m_tree.squared_distance(point(ball.center)) < ball.squared_radius;
  }

private:
  using Triangle = Cloud_kernel::Triangle_3;
  using Triangles = std::vector<Triangle>;

  static Cloud_kernel::Point_3 point(const Cloud_sides_3::Point& p) {
    return {p.x(), p.y(), p.z()};
  }

  Triangles m_triangles;
  AABB_tree<Tree_traits_3<Cloud_kernel, Triangles::const_iterator>> m_tree;
  double m_share = 0;
};

// The surface that a cloud samples: its two sides, and its normal and curvature at each point.
class Sampled_surface_3
{
public:
  using Point = Point_cloud_3::Point;
  using Vector = Point_cloud_3::Vector;

  // Analyzes the points. Normals, if there are any, have any length and sign, and the order of the
  // points. Throws Invalid_points_error if the points bound no solid, or if they sample an open
  // sheet.
  Sampled_surface_3(const std::vector<Point>& points, const std::vector<Vector>& normals,
                    unsigned number_of_threads)
      : m_cloud(points, normals, number_of_threads) {
    m_cloud.keep(surface_points(m_cloud));
    m_cloud.require_volume();
    find_sides();
    if (drop_outliers()) { // outliers influence the sides
      find_sides();
      drop_outliers();
    }
    if (!m_sides->encloses_anything())
      throw Invalid_points_error(Invalid_points_error::Reason::open,
                                 "the points do not enclose a volume: they bound no solid");
    m_holes = std::make_unique<Cloud_holes_3>(m_sides->boundary(m_cloud.reaches()));
    require_solid();
    measure_rooms();
    for (std::size_t i = 0; i < m_cloud.size(); ++i) {
      if (!normals.empty())
        m_normals[i] = unit_vector(normals[m_cloud.index(i)], m_normals[i]);
      if (vector_of(m_sides->outward(i)) * m_normals[i] < 0)
        m_normals[i] = -m_normals[i];
    }
  }

  const Point_cloud_3& cloud() const { return m_cloud; }
  bool is_inside(const Point& p) const {
    return m_sides->is_inside({p.x(), p.y(), p.z()}, m_cloud.nearest(p));
  }

  // Returns the empty balls whose sides are known. They are large compared with the distances of
  // the points, so that a sampled surface cannot cross them. They meet no hole of the cloud.
  std::vector<Cloud_sides_3::Certain_ball> known_balls() const {
    static constexpr double noisy = 4; // in noises: largest distance of points from the surface
    std::vector<Cloud_sides_3::Certain_ball> result;
    for (const auto& ball : m_sides->certain_balls(m_cloud.reaches())) {
      const double depth = known_depth * ball.reach + noisy * m_noise;
      if (ball.ball.squared_radius > depth * depth && !m_holes->meets(ball.ball))
        result.push_back(ball);
    }
    return result;
  }
  // The smallest radius of such balls, in distances of points from their sixth neighbors. Balls at
  // gaps between random points of a sharp edge are smaller.
  static constexpr double known_depth = 1.75;

  // Returns the unit normal of a point. Near a sharp edge, it is the normal of the neighbors on one
  // side.
  const Vector& normal(std::size_t i) const { return m_normals[i]; }
  // Returns whether the normal points outwards. Otherwise its sign is unknown.
  bool is_oriented(std::size_t i) const { return m_sides->outward(i) != NULL_VECTOR; }
  // Returns the radius of the largest outer ball that touches a point or one of its neighbors.
  double room(std::size_t i) const { return m_rooms[i]; }
  // Returns the largest absolute value of the principal curvatures.
  double curvature(std::size_t i) const { return m_curvatures[i]; }
  // Returns whether the surface is not smooth at a point, as at a sharp edge, or has more noise
  // than elsewhere.
  bool is_rough(std::size_t i) const {
    static constexpr double rough = .1; // in spacings
    return m_residuals[i] > (std::max)(rough * m_cloud.spacing(), 2 * m_noise);
  }
  // Returns the median of the residuals of quadrics that are fitted to the neighbors of each point.
  double noise() const { return m_noise; }

private:
  static Vector vector_of(const Cloud_sides_3::Vector& v) { return {v.x(), v.y(), v.z()}; }

  // Returns the unit vector of v, or `otherwise` if v has no direction.
  static Vector unit_vector(const Vector& v, const Vector& otherwise) {
    const double largest = (std::max)({std::abs(v.x()), std::abs(v.y()), std::abs(v.z())});
    if (!(largest > 0) || !std::isfinite(largest))
      return otherwise;
    const Vector w = v / largest;
    const double squared = w.squared_length();
    return std::isfinite(squared) ? w / std::sqrt(squared) : otherwise;
  }

  void require_solid() const {
    static constexpr double most = .25; // of the boundary: a cube without one side is accepted
    if (m_holes->share() <= most)
      return;
    const auto percent = [](double share) { return std::to_string(std::lround(100 * share)); };
    throw Invalid_points_error(
        Invalid_points_error::Reason::sheet,
        "the points sample an open sheet: " + percent(m_holes->share()) +
            " % of the boundary of the enclosed volume has no points, and at most " +
            percent(most) +
            " % can be closed; add points on the missing sides, or reconstruct the sheet "
            "(reconstruct_sheet_3(), --open)");
  }

  void find_sides() {
    static constexpr double noisy = .25; // in spacings; thicker layers are smoothed first
    m_sides = std::make_unique<Cloud_sides_3>(m_cloud.points());
    fit();
    if (can_be_smoothed(m_cloud, m_noise, noisy)) {
      auto sides = std::make_unique<Cloud_sides_3>(smoothed_points(m_cloud, m_noise));
      if (sides->encloses_anything())
        m_sides.swap(sides);
      fit();
    }
  }

  // Removes outliers. A point of a surface has poles on both sides, or a neighbor with such poles.
  // It is also near one of the planes around it. Returns whether there were outliers.
  bool drop_outliers() {
    static constexpr unsigned around = 6;
    std::vector<char> is_kept(m_cloud.size());
    m_cloud.for_each()(m_cloud.size(), [&](std::size_t i) {
      Progress_scope::check();
      const Point& p = m_cloud.points()[i];
      is_kept[i] = is_oriented(i) && m_is_off[i] == 0;
      if (!is_oriented(i) && m_is_off[i] == 0)
        for (std::size_t k : m_cloud.nearest(p, around + 1))
          if (is_oriented(k) && std::sqrt((m_cloud.points()[k] - p).squared_length()) <
                                    reach_of_points * m_cloud.reach(k))
            is_kept[i] = 1;
    });
    if (std::find(is_kept.begin(), is_kept.end(), 0) == is_kept.end())
      return false;
    m_cloud.keep(is_kept);
    m_cloud.require_volume();
    m_sides->keep(is_kept);
    keep_marked(m_normals, is_kept);
    keep_marked(m_residuals, is_kept);
    keep_marked(m_curvatures, is_kept);
    return true;
  }

  void fit() {
    // The number of neighbors: about two rings. In thin parts, only neighbors on one side are used,
    // if they determine a quadric.
    static constexpr unsigned around = 16, least = 6;
    const std::vector<Point>& points = m_cloud.points();
    std::vector<std::vector<std::size_t>> neighbors(points.size());
    std::vector<Fitted_plane_3> planes(points.size());
    m_normals.resize(points.size());
    m_residuals.resize(points.size());
    m_curvatures.resize(points.size());
    m_cloud.for_each()(points.size(), [&](std::size_t i) {
      Progress_scope::check();
      neighbors[i] = m_cloud.nearest(points[i], around + 1); // including the point itself
      const auto is_on_other_side = [&](std::size_t k) {
        return m_sides->outward(k) * m_sides->outward(i) < 0;
      };
      auto& indices = neighbors[i];
      const auto end = std::stable_partition(indices.begin(), indices.end(),
                                             [&](std::size_t k) { return !is_on_other_side(k); });
      if (end - indices.begin() > least)
        indices.erase(end, indices.end());
      std::vector<Point> nearby;
      for (std::size_t k : indices)
        nearby.push_back(points[k]);
      planes[i] = fit_plane(nearby);
      const Fitted_quadric_3 quadric = fit_quadric(nearby, planes[i]);
      m_normals[i] = quadric.normal;
      m_residuals[i] = quadric.residual;
      m_curvatures[i] = quadric.curvature;
    });
    m_noise = median_of(m_residuals);
    static constexpr double rounding = 1e-12; // in spacings
    static constexpr double in_plane = 2;     // in residuals
    m_is_off.resize(points.size());
    m_cloud.for_each()(points.size(), [&](std::size_t i) {
      Progress_scope::check();
      m_is_off[i] = is_off_planes(m_cloud, i, neighbors[i], planes);
      if (!is_rough(i))
        return;
      std::size_t best = i;
      for (std::size_t k : neighbors[i])
        if (planes[k].residual < planes[best].residual &&
            std::abs(planes[k].height(points[i])) <=
                in_plane * planes[k].residual + rounding * m_cloud.spacing())
          best = k;
      m_normals[i] = planes[best].normal;
    });
  }

  // Computes `room()` for all points. In a layer of noise, only some points have large balls.
  void measure_rooms() {
    static constexpr unsigned around = 24; // within about three spacings
    m_rooms.assign(m_cloud.size(), 0);
    m_cloud.for_each()(m_cloud.size(), [&](std::size_t i) {
      Progress_scope::check();
      for (std::size_t k : m_cloud.nearest(m_cloud.points()[i], around))
        if (is_oriented(k) && m_sides->outward(k) * m_sides->outward(i) >= 0)
          m_rooms[i] = (std::max)(m_rooms[i], m_sides->room(k));
    });
  }

  Point_cloud_3 m_cloud;
  std::unique_ptr<Cloud_sides_3> m_sides;
  std::unique_ptr<Cloud_holes_3> m_holes;
  std::vector<Vector> m_normals;
  std::vector<double> m_residuals, m_curvatures, m_rooms;
  std::vector<char> m_is_off; // whether a point is off all planes around it, with outliers
  double m_noise = 0;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_CLOUDS_SAMPLED_SURFACE_3_H
