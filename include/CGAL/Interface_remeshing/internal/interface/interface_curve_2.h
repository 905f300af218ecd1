// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Interface_remeshing, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_REMESHING_INTERNAL_INTERFACE_INTERFACE_CURVE_2_H
#define CGAL_INTERFACE_REMESHING_INTERNAL_INTERFACE_INTERFACE_CURVE_2_H

#include <CGAL/Deformable_simplicial_complexes/internal/interface/Changed_facets.h>
#include <CGAL/Deformable_simplicial_complexes/internal/interface/Interface_fan.h>
#include <CGAL/Deformable_simplicial_complexes/vertex_smoothing.h>

#include <CGAL/determinant.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

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
std::optional<typename Complex::Approximate_point>
curved_midpoint(const Complex& complex, const Interface_fan_2<Complex>& a,
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
  return p + .5 * edge + height * typename Complex::Approximate_vector(-edge.y(), edge.x());
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
  target = complex.exact(p);
  return shorter > (std::min)(a, b) &&
         star_quality(complex, complex.quality_measure(), fan.center(), star, p, 0) >=
             (std::min)(minimum_quality, worst) &&
         complex.is_positive_star(fan.center(), star, target);
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INTERFACE_REMESHING_INTERNAL_INTERFACE_INTERFACE_CURVE_2_H
