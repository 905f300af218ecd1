// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_CREASE_PLANES_3_H
#define CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_CREASE_PLANES_3_H

#include <CGAL/Mesh_support/For_each_index.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/Sampled_surface_3.h>

#include <CGAL/Kernel/global_functions.h>

#include <optional>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The faces around a sharp edge or corner of a sampled surface, and the displacement of a place to
// this edge or corner. The plane of a face is fitted to the points around the place within a
// tolerance of the plane. A face ends at another plane if it has no points beyond that plane.
class Crease_planes_3
{
public:
  using Point = Sampled_surface_3::Point;
  using Vector = Sampled_surface_3::Vector;

  explicit Crease_planes_3(const Sampled_surface_3& surface)
      : m_surface(surface),
        m_tolerance((std::max)(exact * surface.cloud().spacing(), noisy * surface.noise())) {}

  // Returns the displacement of a place near the surface to a corner or a sharp edge, or else to a
  // face. It is null if the place lies on a face, or if there is no sharp edge.
  Vector to_crease(const Point& p) const {
    static constexpr double longest[] = {2, 1.5, 1}; // in spacings: to a face, an edge, a corner
    if (!is_rough_around(p))
      return NULL_VECTOR;
    const std::vector<Plane> planes = planes_around(p);
    if (planes.size() < 2 || lies_on_face(p, planes))
      return NULL_VECTOR;
    for (std::size_t number = (std::min)(planes.size(), std::size_t(3)); number > 0; --number) {
      const auto displacement =
          to_intersection(p, planes, number, longest[number - 1] * m_surface.cloud().spacing());
      if (displacement)
        return *displacement;
    }
    return NULL_VECTOR;
  }

private:
  static constexpr double exact = .1, noisy = 3; // in spacings; in noises
  static constexpr std::size_t least = 5; // number of points of a plane; three lie on any plane

  struct Plane
  {
    Fitted_plane_3 fit;
    double tolerance;
    std::vector<Point> points;
    std::size_t number = 0; // number of points that determine the plane
  };

  bool is_rough_around(const Point& p) const {
    static constexpr unsigned around = 8; // points within about a spacing and a half
    const auto nearby = m_surface.cloud().nearest(p, around);
    return std::any_of(nearby.begin(), nearby.end(),
                       [&](std::size_t i) { return m_surface.is_rough(i); });
  }

  // Returns planes of the points around a place, the largest first. Returns none if the planes
  // contain too few of the points, because the surface is curved then.
  std::vector<Plane> planes_around(const Point& p) const {
    static constexpr unsigned around = 32; // enough for three planes
    static constexpr double explained = .8;
    std::vector<std::size_t> left = m_surface.cloud().nearest(p, around);
    const double required = explained * double(left.size());
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
    if (number < required)
      result.clear();
    return result;
  }

  // Returns the points of the largest plane. Candidates are the planes through each point with its
  // normal.
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

  // Returns whether points lie along a line, so that they determine no plane.
  static bool is_narrow(const Fitted_plane_3& fit) {
    static constexpr double narrow = .2; // of the length
    return fit.width <= narrow * fit.length;
  }

  void fit(const std::vector<Point>& points, Plane& plane) const {
    static constexpr double spread = 3; // in residuals
    plane.fit = fit_plane(points);
    plane.number = points.size();
    plane.tolerance = (std::max)(exact * m_surface.cloud().spacing(), spread * plane.fit.residual);
  }

  // Fits each plane again, without points that are near another plane and may belong to it.
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

  // Returns the standard deviation of the signed distance of a place to the plane, from the
  // residual of its points.
  static double deviation(const Plane& plane, const Point& p) {
    const double away =
        (p - plane.fit.center).squared_length() / (plane.fit.width * plane.fit.width);
    return plane.fit.residual * std::sqrt((1 + away) / double(plane.number));
  }

  // Returns whether a place lies on one of the planes, where its face has points nearby.
  bool lies_on_face(const Point& p, const std::vector<Plane>& planes) const {
    static constexpr double gap = 1.5; // in spacings; larger gaps in a face are rare
    return std::any_of(planes.begin(), planes.end(), [&](const Plane& face) {
      return std::abs(face.fit.height(p)) < face.tolerance && has_points_at(p, face, planes, gap);
    });
  }

  // Returns whether a face has points within a gap of a place, in spacings, on the same side as the
  // place. This must hold for each other plane and for each pair of other planes. At a concave
  // corner, a face has points beyond either of two planes, but not beyond both.
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

  // Returns whether a point is on the same side of a plane as a place. This also holds if the place
  // lies on the plane.
  static bool is_on_side_of(const Point& p, const Point& q, const Plane& plane) {
    const double height = plane.fit.height(p);
    return std::abs(height) < plane.tolerance ||
           (height > 0 ? 1 : -1) * plane.fit.height(q) >= plane.tolerance;
  }

  // Returns the shortest displacement to an intersection of `number` planes where all their faces
  // have points. Returns nothing if it is not shorter than a bound.
  std::optional<Vector> to_intersection(const Point& p, const std::vector<Plane>& planes,
                                        std::size_t number, double bound) const {
    static constexpr double gap = 2.5; // in spacings: between a crease and the points near it
    // In standard deviations: shorter displacements may be due to noise. The factor also covers
    // points of other faces that were assigned to the planes.
    static constexpr double sure = 6;
    std::optional<Vector> result;
    std::vector<char> is_chosen(planes.size(), 0);
    std::fill(is_chosen.begin(), is_chosen.begin() + std::ptrdiff_t(number), 1);
    do {
      std::vector<const Plane*> chosen;
      for (std::size_t i = 0; i < planes.size(); ++i)
        if (is_chosen[i] != 0)
          chosen.push_back(&planes[i]);
      const auto displacement = to_intersection(p, chosen);
      if (!displacement || !(displacement->squared_length() < bound * bound))
        continue;
      if (std::all_of(chosen.begin(), chosen.end(), [&](const Plane* face) {
            return has_points_at(p + *displacement, *face, planes, gap) &&
                   sure * deviation(*face, p + *displacement) <
                       std::sqrt(displacement->squared_length());
          })) {
        bound = std::sqrt(displacement->squared_length());
        result = displacement;
      }
    } while (std::prev_permutation(is_chosen.begin(), is_chosen.end()));
    return result;
  }

  // Returns the shortest displacement to the intersection of planes, or nothing if they are nearly
  // parallel.
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

// An edge to split, and the destination of the new vertex.
struct Crease_split_3
{
  std::array<std::size_t, 2> edge;
  Crease_planes_3::Point destination;
  double squared_distance; // from the surface to the destination
};

// Returns the edges of a surface that cut across a crease: edges whose midpoint is near a crease
// but not on it, and the longest edge of each facet whose centroid is. A facet may cut off a corner
// although all its edges touch the corner. No facet has two of the edges, because one new vertex
// may be enough. The edges are sorted by decreasing distance from the crease. Edges shorter than
// `shortest` are omitted.
template <class Facets>
std::vector<Crease_split_3>
edges_across_creases(const Crease_planes_3& planes, const Facets& facets,
                     const std::vector<Crease_planes_3::Point>& positions, double shortest,
                     const For_each_index& for_each) {
  using Edge = std::array<std::size_t, 2>;
  const auto squared_length = [&](const Edge& e) {
    return (positions[e[0]] - positions[e[1]]).squared_length();
  };
  std::map<Edge, std::vector<std::size_t>> facets_of_edges;
  std::vector<Crease_split_3> candidates; // destinations are on the surface at first
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const auto& v = facets[f].vertices;
    Edge longest = {{v[0], v[1]}};
    for (std::size_t k = 0; k < 3; ++k) {
      const Edge e = {{(std::min)(v[k], v[(k + 1) % 3]), (std::max)(v[k], v[(k + 1) % 3])}};
      facets_of_edges[e].push_back(f);
      if (squared_length(e) >= squared_length(longest))
        longest = e;
    }
    candidates.push_back(
        {longest, CGAL::centroid(positions[v[0]], positions[v[1]], positions[v[2]]), 0});
  }
  for (const auto& [e, around] : facets_of_edges)
    candidates.push_back({e, CGAL::midpoint(positions[e[0]], positions[e[1]]), 0});
  for_each(candidates.size(), [&](std::size_t i) {
    Progress_scope::check();
    Crease_split_3& c = candidates[i];
    if (squared_length(c.edge) < shortest * shortest)
      return;
    const auto displacement = planes.to_crease(c.destination);
    c.destination = c.destination + displacement;
    c.squared_distance = displacement.squared_length();
  });
  std::stable_sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
    return a.squared_distance > b.squared_distance;
  });
  std::vector<char> is_taken(facets.size(), 0);
  std::vector<Crease_split_3> result;
  for (const Crease_split_3& c : candidates) {
    const std::vector<std::size_t>& around = facets_of_edges[c.edge];
    if (!(c.squared_distance > 0) ||
        std::any_of(around.begin(), around.end(), [&](std::size_t f) { return is_taken[f] != 0; }))
      continue;
    for (std::size_t f : around)
      is_taken[f] = 1;
    result.push_back(c);
  }
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_CREASE_PLANES_3_H
