// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_RECONSTRUCTION_CREASE_PLANES_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_RECONSTRUCTION_CREASE_PLANES_3_H

#include <CGAL/Deformable_simplicial_complex_3/internal/clouds/Sampled_surface_3.h>

#include <CGAL/Origin.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// The planes that meet in a sharp edge or corner of a sampled surface, and the displacement of a
// place beside the edge to it. The planes are fitted to the points around the place, each to the
// points that are within a tolerance of it.
class Crease_planes_3
{
public:
  using Point = Sampled_surface_3::Point;
  using Vector = Sampled_surface_3::Vector;

  explicit Crease_planes_3(const Sampled_surface_3& surface)
      : m_surface(surface),
        m_tolerance((std::max)(exact * surface.cloud().spacing(), noisy * surface.noise())) {}

  // Returns the displacement of a place to where planes meet, or null if the place lies on one of
  // the planes, or there is no sharp edge.
  Vector to_crease(const Point& p) const {
    static constexpr double longest[] = {1.5, 1}; // spacings: to an edge, to a corner
    if (!is_rough_around(p))
      return NULL_VECTOR;
    std::vector<Plane> planes = planes_around(p);
    if (planes.size() < 2 || lies_on_face(p, planes))
      return NULL_VECTOR;
    std::stable_sort(planes.begin(), planes.end(), [&](const Plane& a, const Plane& b) {
      return std::abs(a.fit.height(p)) < std::abs(b.fit.height(p));
    });
    for (const std::size_t number : {std::size_t(3), std::size_t(2)}) {
      if (planes.size() < number)
        continue;
      const std::vector<Plane> nearest(planes.begin(), planes.begin() + std::ptrdiff_t(number));
      const auto way = to_intersection(p, nearest);
      const double bound = longest[number - 2] * m_surface.cloud().spacing();
      if (way && way->squared_length() < bound * bound)
        return *way;
    }
    return NULL_VECTOR;
  }

private:
  static constexpr double exact = .1, noisy = 3; // spacings, noises
  static constexpr std::size_t least = 5;        // points of a plane: three lie on any

  struct Plane
  {
    Fitted_plane_3 fit;
    double tolerance;
    std::vector<Point> points;
  };

  bool is_rough_around(const Point& p) const {
    static constexpr unsigned around = 8; // those within about a spacing and a half
    const auto near = m_surface.cloud().nearest(p, around);
    return std::any_of(near.begin(), near.end(),
                       [&](std::size_t i) { return m_surface.is_rough(i); });
  }

  // The planes of most of the points around, largest first; none if the planes do not explain most
  // points, as the surface is curved then.
  std::vector<Plane> planes_around(const Point& p) const {
    static constexpr unsigned around = 32; // enough for three planes
    static constexpr double explained = .8;
    std::vector<std::size_t> left = m_surface.cloud().nearest(p, around);
    const double wanted = explained * double(left.size());
    double number = 0;
    std::vector<Plane> result;
    while (left.size() >= least) {
      const std::vector<std::size_t> found = largest_plane(left);
      if (found.size() < least)
        break;
      left.erase(std::remove_if(left.begin(), left.end(),
                                [&](std::size_t i) {
                                  return std::find(found.begin(), found.end(), i) != found.end();
                                }),
                 left.end());
      add_plane(found, result);
    }
    for (const Plane& plane : result)
      number += double(plane.points.size());
    if (number < wanted)
      result.clear();
    return result;
  }

  // Of the planes through points, along their normals: the points of that with most of them.
  std::vector<std::size_t> largest_plane(const std::vector<std::size_t>& candidates) const {
    const auto& points = m_surface.cloud().points();
    std::vector<std::size_t> result, members;
    for (std::size_t seed : candidates) {
      members.clear();
      for (std::size_t i : candidates)
        if (std::abs(m_surface.normal(seed) * (points[i] - points[seed])) <= m_tolerance)
          members.push_back(i);
      if (members.size() > result.size())
        result = members;
    }
    return result;
  }

  void add_plane(const std::vector<std::size_t>& members, std::vector<Plane>& planes) const {
    static constexpr double narrow = .2; // of the length: points along a line determine no plane
    static constexpr double spread = 3;  // residuals
    Plane plane{{}, 0, {}};
    for (std::size_t i : members)
      plane.points.push_back(m_surface.cloud().points()[i]);
    plane.fit = fit_plane(plane.points);
    plane.tolerance = (std::max)(exact * m_surface.cloud().spacing(), spread * plane.fit.residual);
    if (plane.fit.width > narrow * plane.fit.length)
      planes.push_back(plane);
  }

  // Whether a place is on one of the planes, and not beyond another plane at which it ends.
  static bool lies_on_face(const Point& p, const std::vector<Plane>& planes) {
    return std::any_of(planes.begin(), planes.end(), [&](const Plane& face) {
      return std::abs(face.fit.height(p)) < face.tolerance &&
             std::all_of(planes.begin(), planes.end(), [&](const Plane& other) {
               return &other == &face || !ends_before(face, other, p);
             });
    });
  }

  // Whether all points of a face are on one side of another plane, and a place is on the other.
  static bool ends_before(const Plane& face, const Plane& other, const Point& p) {
    double low = 0, high = 0;
    for (const Point& q : face.points) {
      low = (std::min)(low, other.fit.height(q));
      high = (std::max)(high, other.fit.height(q));
    }
    const double height = other.fit.height(p);
    if (low > -other.tolerance)
      return height <= -other.tolerance;
    return high < other.tolerance && height >= other.tolerance;
  }

  // Returns the shortest displacement to where planes meet, or nothing if they are nearly parallel
  // or one has no points near there.
  std::optional<Vector> to_intersection(const Point& p, const std::vector<Plane>& planes) const {
    static constexpr double parallel =
        .09;                           // of the largest eigenvalue: 33 degrees between two planes
    static constexpr double gap = 2.5; // spacings: between a crease and the points beside it
    const auto n = Eigen::Index(planes.size());
    Eigen::MatrixXd normals(n, 3);
    Eigen::VectorXd heights(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Fitted_plane_3& fit = planes[std::size_t(i)].fit;
      normals.row(i) << fit.normal.x(), fit.normal.y(), fit.normal.z();
      heights[i] = fit.height(p);
    }
    const Eigen::MatrixXd products = normals * normals.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(products);
    if (solver.eigenvalues()[0] < parallel * solver.eigenvalues()[n - 1])
      return std::nullopt;
    const Eigen::VectorXd x = -normals.transpose() * products.ldlt().solve(heights);
    const Vector way(x[0], x[1], x[2]);
    const double reach = gap * m_surface.cloud().spacing();
    const bool is_near_all = std::all_of(planes.begin(), planes.end(), [&](const Plane& plane) {
      return std::any_of(plane.points.begin(), plane.points.end(), [&](const Point& q) {
        return (q - (p + way)).squared_length() < reach * reach;
      });
    });
    return is_near_all ? std::optional<Vector>(way) : std::nullopt;
  }

  const Sampled_surface_3& m_surface;
  double m_tolerance; // of the distance of points from their plane
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_RECONSTRUCTION_CREASE_PLANES_3_H
