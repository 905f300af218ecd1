// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_CLOUD_APPROACH_3_H
#define CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_CLOUD_APPROACH_3_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/Sampled_surface_3.h>
#include <CGAL/Solid_reconstruction_3/internal/reconstruction/Cloud_facets_3.h>

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

// The motion of an interface towards a cloud (section 4.3 of the paper). Facets with points move
// their vertices to the planes of these points. Free facets move their vertices inwards, as long as
// the space in front of them is outside the solid.
class Cloud_approach_3
{
public:
  using Point = Sampled_surface_3::Point;
  using Vector = Sampled_surface_3::Vector;

  std::vector<Vector> displacements; // displacements of the vertices
  std::vector<char> is_free;         // whether a facet is free
  std::vector<char> is_at_free;      // whether a vertex belongs to a free facet

  template <class Facets>
  Cloud_approach_3(const Sampled_surface_3& surface, const Facets& facets,
                   const std::vector<Point>& positions, const Cloud_triangles_3& triangles,
                   const Cloud_planes_3& planes) {
    std::vector<Corner> corners(positions.size());
    is_at_free.assign(positions.size(), 0);
    const For_each_index& for_each = surface.cloud().for_each();
    std::vector<double> steps(triangles.size(), 0);
    for_each(triangles.size(), [&](std::size_t f) {
      Progress_scope::check();
      const auto& t = triangles[f];
      const Vector across = cross_product(t[1] - t[0], t[2] - t[0]);
      const double twice_area = std::sqrt(across.squared_length());
      if (twice_area > 0 && !planes[f].touches)
        steps[f] =
            free_step(surface, CGAL::centroid(t), across / twice_area, std::sqrt(twice_area));
    });
    for (std::size_t f = 0; f < triangles.size(); ++f) {
      const auto& t = triangles[f];
      const Vector across = cross_product(t[1] - t[0], t[2] - t[0]);
      const double twice_area = std::sqrt(across.squared_length()), step = steps[f];
      is_free.push_back(step > 0);
      if (!(twice_area > 0))
        continue;
      const Vector normal = across / twice_area;
      for (int k = 0; k < 3; ++k) {
        const Vector a = t[k + 1] - t[k], b = t[k + 2] - t[k];
        const double angle = std::atan2(twice_area, a * b);
        Corner& c = corners[facets[f].vertices[std::size_t(k)]];
        if (step > 0)
          is_at_free[facets[f].vertices[std::size_t(k)]] = 1;
        c.edges += std::sqrt(a.squared_length());
        ++c.number;
        if (planes[f].touches)
          c.add_plane(angle, planes[f].normal, planes[f].normal * (planes[f].center - t[k]));
        else
          c.add_push(angle, -step * normal);
      }
    }
    displacements.resize(positions.size());
    for_each(positions.size(), [&](std::size_t v) {
      Progress_scope::check();
      displacements[v] = corners[v].displacement();
      if (is_at_free[v] != 0 && !surface.is_inside(positions[v]))
        for (int i = 0; i < halvings && surface.is_inside(positions[v] + displacements[v]); ++i)
          displacements[v] = i + 1 < halvings ? displacements[v] / 2 : Vector(0, 0, 0);
    });
  }

private:
  static constexpr int halvings = 4; // of displacements that end in the solid

  // Sums over the facets at a vertex, weighted by their angles.
  struct Corner
  {
    Eigen::Matrix3d quadric = Eigen::Matrix3d::Zero();
    Eigen::Vector3d sum = Eigen::Vector3d::Zero(), push = Eigen::Vector3d::Zero();
    double plane_angle = 0, push_angle = 0, edges = 0;
    int number = 0;

    void add_plane(double angle, const Vector& normal, double height) {
      const Eigen::Vector3d n(normal.x(), normal.y(), normal.z());
      quadric += angle * n * n.transpose();
      sum += angle * height * n;
      plane_angle += angle;
    }
    void add_push(double angle, const Vector& vector) {
      push += angle * Eigen::Vector3d(vector.x(), vector.y(), vector.z());
      push_angle += angle;
    }
    // Returns the displacement to the intersection of the planes. In directions that the planes do
    // not determine, it is the displacement of the free facets.
    Vector displacement() const {
      static constexpr double least_eigenvalue = .1; // of the largest eigenvalue
      static constexpr double farthest = .4;         // in edges
      Eigen::Vector3d result = Eigen::Vector3d::Zero();
      if (push_angle > 0)
        result = push / push_angle;
      if (plane_angle > 0) {
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(quadric);
        const Eigen::Vector3d pushed = result;
        result.setZero();
        for (int k = 0; k < 3; ++k) {
          const Eigen::Vector3d axis = solver.eigenvectors().col(k);
          const double value = solver.eigenvalues()[k];
          result += (value > least_eigenvalue * solver.eigenvalues()[2] ? axis.dot(sum) / value
                                                                        : axis.dot(pushed)) *
                    axis;
        }
      }
      const double bound = number > 0 ? farthest * edges / number : 0;
      if (result.norm() > bound)
        result *= bound / result.norm();
      return {result[0], result[1], result[2]};
    }
  };

  // Returns the length by which a facet without a plane moves inwards, without entering the solid.
  static double free_step(const Sampled_surface_3& surface, const Point& middle,
                          const Vector& normal, double edge) {
    static constexpr double push = .35, part = .7; // in edges; in distances from points
    static constexpr double nearby = 1;            // in spacings; nearer facets do not move
    const double distance = surface.cloud().distance(middle);
    if (distance < nearby * surface.cloud().spacing() || surface.is_inside(middle))
      return 0;
    double result = (std::min)(push * edge, part * distance);
    for (int i = 0; i < halvings && surface.is_inside(middle - result * normal); ++i)
      result = i + 1 < halvings ? result / 2 : 0;
    return result;
  }
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_CLOUD_APPROACH_3_H
