// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_CREASE_PLANES_3_H
#define CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_CREASE_PLANES_3_H

#include <CGAL/Solid_reconstruction_3/internal/clouds/Sampled_surface_3.h>

#include <CGAL/Origin.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// The faces around a sharp edge or corner of a sampled surface, and the displacement of a place to
// them. The planes of faces are fitted to the points around the place, each to the points that are
// within a tolerance of it; a face ends at other planes where it has no points beyond them.
class Crease_planes_3
{
public:
  using Point = Sampled_surface_3::Point;
  using Vector = Sampled_surface_3::Vector;

  explicit Crease_planes_3(const Sampled_surface_3& surface)
      : m_surface(surface),
        m_tolerance((std::max)(exact * surface.cloud().spacing(), noisy * surface.noise())) {}

  // Returns the displacement of a place beside the surface to a corner or sharp edge of it, or else
  // to a face; null if the place lies on a face, or there is no sharp edge.
  Vector to_crease(const Point& p) const {
    static constexpr double longest[] = {2, 1.5, 1}; // spacings: to a face, an edge, a corner
    if (!is_rough_around(p))
      return NULL_VECTOR;
    const std::vector<Plane> planes = planes_around(p);
    if (planes.size() < 2 || lies_on_face(p, planes))
      return NULL_VECTOR;
    for (std::size_t number = (std::min)(planes.size(), std::size_t(3)); number > 0; --number) {
      const auto way =
          to_intersection(p, planes, number, longest[number - 1] * m_surface.cloud().spacing());
      if (way)
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
    std::size_t number = 0; // of points that the plane is fitted to
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
    refit(result);
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
    Plane plane{{}, 0, {}};
    for (std::size_t i : members)
      plane.points.push_back(m_surface.cloud().points()[i]);
    fit(plane.points, plane);
    if (!is_narrow(plane.fit))
      planes.push_back(plane);
  }

  // Points along a line determine no plane.
  static bool is_narrow(const Fitted_plane_3& fit) {
    static constexpr double narrow = .2; // of the length
    return fit.width <= narrow * fit.length;
  }

  void fit(const std::vector<Point>& points, Plane& plane) const {
    static constexpr double spread = 3; // residuals
    plane.fit = fit_plane(points);
    plane.number = points.size();
    plane.tolerance = (std::max)(exact * m_surface.cloud().spacing(), spread * plane.fit.residual);
  }

  // Fits planes to their points without those that are near other planes, too, and may be of these.
  void refit(std::vector<Plane>& planes) const {
    std::vector<std::vector<Point>> own(planes.size());
    for (std::size_t k = 0; k < planes.size(); ++k)
      std::copy_if(planes[k].points.begin(), planes[k].points.end(), std::back_inserter(own[k]),
                   [&](const Point& p) {
                     return std::all_of(planes.begin(), planes.end(), [&](const Plane& other) {
                       return &other == &planes[k] ||
                              std::abs(other.fit.height(p)) > other.tolerance;
                     });
                   });
    for (std::size_t k = 0; k < planes.size(); ++k)
      if (own[k].size() >= least && !is_narrow(fit_plane(own[k])))
        fit(own[k], planes[k]);
  }

  // The standard deviation of the height of a place above the plane, by the residual of its points.
  static double deviation(const Plane& plane, const Point& p) {
    const double away =
        (p - plane.fit.center).squared_length() / (plane.fit.width * plane.fit.width);
    return plane.fit.residual * std::sqrt((1 + away) / double(plane.number));
  }

  // Whether a place is on one of the planes where its face has points nearby.
  bool lies_on_face(const Point& p, const std::vector<Plane>& planes) const {
    static constexpr double gap = 1.5; // spacings: places of a face are rarely farther from points
    return std::any_of(planes.begin(), planes.end(), [&](const Plane& face) {
      return std::abs(face.fit.height(p)) < face.tolerance && has_points_at(p, face, planes, gap);
    });
  }

  // Whether a face has points within a gap, in spacings, of a place, and on its side of each other
  // plane and of each two of them: near a concave corner, a face has points beyond either plane,
  // but not beyond both.
  bool has_points_at(const Point& p, const Plane& face, const std::vector<Plane>& planes,
                     double gap) const {
    const double reach = gap * m_surface.cloud().spacing();
    for (const Plane& a : planes)
      for (const Plane& b : planes)
        if (&a <= &b && &a != &face && &b != &face &&
            std::none_of(face.points.begin(), face.points.end(), [&](const Point& q) {
              return (q - p).squared_length() < reach * reach && is_on_side_of(p, q, a) &&
                     is_on_side_of(p, q, b);
            }))
          return false;
    return true;
  }

  // Whether a point is on the side of a plane on which a place is; each is if the place lies on it.
  static bool is_on_side_of(const Point& p, const Point& q, const Plane& plane) {
    const double height = plane.fit.height(p);
    return std::abs(height) < plane.tolerance ||
           (height > 0 ? 1 : -1) * plane.fit.height(q) >= plane.tolerance;
  }

  // Returns the shortest displacement to where that number of planes meet and all their faces have
  // points, or nothing if it is not below a bound.
  std::optional<Vector> to_intersection(const Point& p, const std::vector<Plane>& planes,
                                        std::size_t number, double bound) const {
    static constexpr double gap = 2.5; // spacings: between a crease and the points beside it
    // Standard deviations: a displacement that is shorter may be due to noise. Beside the noise,
    // the planes are off by points of other faces that are near enough to be mistaken for theirs.
    static constexpr double sure = 6;
    std::optional<Vector> result;
    std::vector<char> is_chosen(planes.size(), 0);
    std::fill(is_chosen.begin(), is_chosen.begin() + std::ptrdiff_t(number), 1);
    do {
      std::vector<const Plane*> chosen;
      for (std::size_t i = 0; i < planes.size(); ++i)
        if (is_chosen[i] != 0)
          chosen.push_back(&planes[i]);
      const auto way = to_intersection(p, chosen);
      if (!way || !(way->squared_length() < bound * bound))
        continue;
      if (std::all_of(chosen.begin(), chosen.end(), [&](const Plane* face) {
            return has_points_at(p + *way, *face, planes, gap) &&
                   sure * deviation(*face, p + *way) < std::sqrt(way->squared_length());
          })) {
        bound = std::sqrt(way->squared_length());
        result = way;
      }
    } while (std::prev_permutation(is_chosen.begin(), is_chosen.end()));
    return result;
  }

  // Returns the shortest displacement to where planes meet, or nothing if they are nearly parallel.
  static std::optional<Vector> to_intersection(const Point& p,
                                               const std::vector<const Plane*>& planes) {
    static constexpr double parallel =
        .09; // of the largest eigenvalue: 33 degrees between two planes
    const auto n = Eigen::Index(planes.size());
    Eigen::MatrixXd normals(n, 3);
    Eigen::VectorXd heights(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Fitted_plane_3& fit = planes[std::size_t(i)]->fit;
      normals.row(i) << fit.normal.x(), fit.normal.y(), fit.normal.z();
      heights[i] = fit.height(p);
    }
    const Eigen::MatrixXd products = normals * normals.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(products);
    if (solver.eigenvalues()[0] < parallel * solver.eigenvalues()[n - 1])
      return std::nullopt;
    const Eigen::VectorXd x = -normals.transpose() * products.ldlt().solve(heights);
    return Vector(x[0], x[1], x[2]);
  }

  const Sampled_surface_3& m_surface;
  double m_tolerance; // of the distance of points from their plane
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_CREASE_PLANES_3_H
