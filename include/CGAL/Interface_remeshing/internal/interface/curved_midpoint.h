// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_INTERNAL_INTERFACE_CURVED_MIDPOINT_H
#define CGAL_INTERFACE_REMESHING_INTERNAL_INTERFACE_CURVED_MIDPOINT_H

#include <CGAL/Deformable_simplicial_complexes/internal/interface/Changed_facets.h>
#include <CGAL/Deformable_simplicial_complexes/internal/interface/Interface_fan.h>
#include <CGAL/Deformable_simplicial_complexes/internal/operations/triangle_quality.h>
#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>

#include <Eigen/Dense>

#include <optional>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the change of the edges of a fan when its center is collapsed into a neighbor.
template <class Complex>
Changed_facets facets_changed_by_collapse(const Complex& complex,
                                          const Interface_fan_2<Complex>& fan,
                                          typename Complex::Vertex_handle kept) {
  const auto [previous, next] = fan.neighbors();
  const auto before = complex.displacement(previous, fan.center()),
             after = complex.displacement(fan.center(), next), both = before + after;
  const bool turns_over =
      (kept != previous && kept != next) || !(both * before > 0 && both * after > 0);
  return {1, turns_over ? 0. : 1., std::abs(determinant(before, after)) / 2};
}

// Returns the point beside the midpoint of the edge between two fan centers on a cubic curve. The
// curve is a function over the edge, and passes through both centers and their other neighbors.
// Returns `nullopt` where the curve would be steep.
template <class Complex>
std::optional<typename Complex::Point> curved_midpoint(const Complex& complex,
                                                       const Interface_fan_2<Complex>& a,
                                                       const Interface_fan_2<Complex>& b) {
  const auto p = complex.position(a.center());
  const auto edge = complex.position_near(p, b.center()) - p;
  const auto beyond = [&](const Interface_fan_2<Complex>& fan, const auto& from, auto than) {
    const auto& neighbors = fan.neighbors();
    return complex.position_near(from, neighbors[neighbors[0] == than ? 1 : 0]) - p;
  };
  const auto before = beyond(a, p, b.center()), after = beyond(b, p + edge, a.center());
  // With the edge from (0, 0) to (1, 0), a cubic that vanishes at both ends is x (x - 1) (s + t x).
  const double squared_length = edge.squared_length();
  const double x = before * edge / squared_length, y = determinant(edge, before) / squared_length,
               u = after * edge / squared_length, v = determinant(edge, after) / squared_length;
  if (!(-x > std::abs(y) && u - 1 > std::abs(v))) // steeper than 45 degrees
    return std::nullopt;
  const double at_x = y / (x * (x - 1)), at_u = v / (u * (u - 1)),
               at_middle = at_x + (at_u - at_x) * (.5 - x) / (u - x);
  static constexpr double highest = .25; // height above the edge, in edge lengths
  const double height = std::clamp(-.25 * at_middle, -highest, highest);
  return p + .5 * edge + height * typename Complex::Vector(-edge.y(), edge.x());
}

// Computes the smoothed position of the center of a fan. The center moves parallel to the line
// through its neighbors, so that no label gains or loses area. It moves towards the mean of the
// edge midpoints, weighted by the edge lengths. Returns false if the center must stay: the turning
// angle is too large to tell the tangent direction from the eigenvalues of the quadric. For edges
// of equal length, the ratio of these eigenvalues is the squared tangent of half the turning angle.
// Also returns false if a cell would be inverted, the quality would fall below the bound, or the
// shorter edge would not become longer.
template <class Complex>
bool null_space_position(const Complex& complex, const Interface_fan_2<Complex>& fan,
                         const std::vector<typename Complex::Cell_handle>& star,
                         double aggressiveness, double feature_angle, double minimum_quality,
                         typename Complex::Point& target) {
  if (complex.is_boundary(fan.center()) || !fan.is_disk() ||
      fan.rank_by_features(feature_angle) != 1)
    return false;
  const auto to_previous = complex.displacement(fan.center(), fan.neighbors()[0]),
             to_next = complex.displacement(fan.center(), fan.neighbors()[1]),
             along = to_next - to_previous;
  const double a = std::sqrt(to_previous.squared_length()), b = std::sqrt(to_next.squared_length());
  const double tangent = std::tan(turn_between(-to_previous, to_next) / 2);
  if (!(tangent * tangent < aggressiveness) || !(along.squared_length() > 0))
    return false;
  const auto to_mean = (a * to_previous + b * to_next) / (2 * (a + b));
  const auto step = (to_mean * along) / along.squared_length() * along;

  double worst = std::numeric_limits<double>::infinity();
  for (auto c : star)
    worst = (std::min)(worst, c->quality());
  const auto p = complex.position(fan.center()) + step;
  const double shorter = std::sqrt(
      (std::min)((to_previous - step).squared_length(), (to_next - step).squared_length()));
  target = p;
  return shorter > (std::min)(a, b) &&
         star_quality(complex, complex.quality_measure(), fan.center(), star, p, 0) >=
             (std::min)(minimum_quality, worst) &&
         complex.is_positive_star(fan.center(), star, target);
}

// Returns the unit normal at the center of a fan; a null vector if the facet normals cancel each
// other.
template <class Complex>
typename Complex::Vector_3 normal_of(const Interface_fan_3<Complex>& fan, const Complex& complex) {
  using Vector = typename Complex::Vector_3;
  const auto p = complex.position(fan.center());
  Vector sum(0, 0, 0);
  for (std::size_t i = 0; i < fan.size(); ++i) {
    const auto f = fan.facet(i, p);
    const Vector area = area_vector(f);
    const double length = std::sqrt(area.squared_length());
    if (length > 0)
      sum = sum + angle_between(f[1] - p, f[2] - p) / length * area;
  }
  const double length = std::sqrt(sum.squared_length());
  return length > 0 ? sum / length : sum;
}

// Returns the midpoint of a cubic curve between the centers of two fans that is perpendicular to
// their normals (A. Vlachos and others, Curved PN triangles, I3D 2001). Used for surfaces that are
// too steep for a height function over a plane.
template <class Complex>
typename Complex::Point_3 midpoint_by_normals(const Complex& complex,
                                              const Interface_fan_3<Complex>& a,
                                              const Interface_fan_3<Complex>& b) {
  const auto p = complex.position(a.center()), q = complex.position_near(p, b.center());
  const auto n = normal_of(a, complex), m = normal_of(b, complex);
  return midpoint(p, q) - (((q - p) * n) * n + ((p - q) * m) * m) / 8;
}

// Returns the estimated position of the midpoint of an edge on the smooth surface that the
// interface approximates. A quadric, as a height function over the mean tangent plane of the two
// fans, is fitted to the vertices of the fans. Where a facet is inclined to that plane by more than
// 45 degrees, midpoint_by_normals() is used instead. Returns `nullopt` if there are too few
// vertices for the fit, or the facet normals cancel each other.
template <class Complex>
std::optional<typename Complex::Point_3> curved_midpoint(const Complex& complex,
                                                         const Interface_fan_3<Complex>& a,
                                                         const Interface_fan_3<Complex>& b) {
  using Vector = typename Complex::Vector_3;
  static constexpr Eigen::Index coefficients = 6;
  static constexpr double steep_cosine = .7071;
  const auto p = complex.position(a.center()), q = complex.position_near(p, b.center());
  const auto middle = midpoint(p, q);
  Vector normal(0, 0, 0);
  std::vector<typename Complex::Vertex_handle> vertices;
  for (const Interface_fan_3<Complex>* fan : {&a, &b}) {
    for (std::size_t i = 0; i < fan->size(); ++i)
      normal = normal + area_vector(fan->facet(i, complex.position(fan->center())));
    fan->for_each_neighbor([&](auto v) { vertices.push_back(v); });
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  const Eigen::Index n = Eigen::Index(vertices.size());
  const double normal_length = std::sqrt(normal.squared_length());
  if (n <= coefficients || !(normal_length > 0))
    return std::nullopt;
  normal = normal / normal_length;
  for (const Interface_fan_3<Complex>* fan : {&a, &b})
    for (std::size_t i = 0; i < fan->size(); ++i) {
      const Vector n_i = area_vector(fan->facet(i, complex.position(fan->center())));
      if (!(n_i * normal > steep_cosine * std::sqrt(n_i.squared_length())))
        return midpoint_by_normals(complex, a, b);
    }
  Vector along = (q - p) - ((q - p) * normal) * normal;
  const double length = std::sqrt(along.squared_length());
  if (!(length > 0))
    return std::nullopt;
  along = along / length;
  const Vector across = cross_product(normal, along);

  Eigen::Matrix<double, Eigen::Dynamic, coefficients> rows(n, coefficients);
  Eigen::VectorXd heights(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Vector d = (complex.position_near(middle, vertices[std::size_t(i)]) - middle) / length;
    const double x = d * along, y = d * across;
    const double weight = 1 / (.25 + x * x + y * y); // largest at the ends of the edge
    rows.row(i) << weight, weight * x, weight * y, weight * x * x, weight * x * y, weight * y * y;
    heights(i) = weight * (d * normal);
  }
  // Limits the height, in units of the edge length: larger heights are artifacts of the fit.
  static constexpr double highest = .25;
  const double height = rows.colPivHouseholderQr().solve(heights)(0);
  return middle + length * std::clamp(height, -highest, highest) * normal;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INTERFACE_REMESHING_INTERNAL_INTERFACE_CURVED_MIDPOINT_H
