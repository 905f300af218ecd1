// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_BENCHMARK_GEAR_H
#define DSC_BENCHMARK_GEAR_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace dsc_benchmark::clouds {

/// A gear with a hole about the z axis: a solid with many convex and concave sharp edges.
class Gear
{
public:
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

  explicit Gear(unsigned teeth) {
    static constexpr double half_tip = .153, root = .248; // fraction of the angle of a tooth
    const double angle = 2 * CGAL_PI / teeth;
    for (unsigned k = 0; k < teeth; ++k)
      for (const auto& [part, radius] :
           {std::make_pair(-half_tip, tip), std::make_pair(half_tip, tip), std::make_pair(root, 1.),
            std::make_pair(1 - root, 1.)})
        m_outline.push_back(
            {{radius * std::cos((k + part) * angle), radius * std::sin((k + part) * angle)}});
  }

  double volume() const { return height * area_of_cover(); }
  double area() const {
    return 2 * area_of_cover() + height * (length_of_outline() + 2 * CGAL_PI * hole);
  }

  /// Returns evenly distributed points: one random point in each cell of grids with about this side
  /// length.
  /// \param uniform returns random numbers between 0 and 1
  template <class Uniform> std::vector<Point> sample(double side, Uniform&& uniform) const {
    std::vector<Point> result;
    for (std::size_t i = 0; i < m_outline.size(); ++i) {
      const Place &a = m_outline[i], &b = m_outline[(i + 1) % m_outline.size()];
      sample_wall(length(a, b), side, uniform, result, [&](double t) {
        return Place{{a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])}};
      });
    }
    sample_wall(2 * CGAL_PI * hole, side, uniform, result, &Gear::place_on_hole);
    for (const double z : {0., height})
      for (double x = -tip; x < tip; x += side)
        for (double y = -tip; y < tip; y += side) {
          const double u = x + side * uniform(), v = y + side * uniform();
          if (signed_distance({{u, v}}) < 0)
            result.emplace_back(u, v, z);
        }
    return result;
  }

  /// Returns the distance from the surface.
  double distance(const Point& p) const {
    const double across = signed_distance({{p.x(), p.y()}}),
                 along = std::abs(p.z() - height / 2) - height / 2;
    return across < 0 && along < 0 ? -(std::max)(across, along)
                                   : std::hypot((std::max)(0., across), (std::max)(0., along));
  }

  /// Returns points on the sharp edges.
  std::vector<Point> creases() const {
    static constexpr int n = 20; // number of points on an edge of a tooth
    std::vector<Point> result;
    for (std::size_t i = 0; i < m_outline.size(); ++i) {
      const Place &a = m_outline[i], &b = m_outline[(i + 1) % m_outline.size()];
      for (int k = 0; k < n; ++k) {
        const double t = (k + .5) / n;
        for (const double z : {0., height})
          result.emplace_back(a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), z);
        result.emplace_back(a[0], a[1], t * height);
      }
    }
    for (int k = 0; k < 20 * n; ++k)
      for (const double z : {0., height}) {
        const Place p = place_on_hole((k + .5) / (20 * n));
        result.emplace_back(p[0], p[1], z);
      }
    return result;
  }

private:
  using Place = std::array<double, 2>;
  static constexpr double tip = 1.25, hole = .4, height = .5; // radii of the teeth and of the hole

  static double length(const Place& a, const Place& b) {
    return std::hypot(b[0] - a[0], b[1] - a[1]);
  }
  static Place place_on_hole(double t) {
    return {{hole * std::cos(2 * CGAL_PI * t), hole * std::sin(2 * CGAL_PI * t)}};
  }

  double length_of_outline() const {
    double result = 0;
    for (std::size_t i = 0; i < m_outline.size(); ++i)
      result += length(m_outline[i], m_outline[(i + 1) % m_outline.size()]);
    return result;
  }

  double area_of_cover() const {
    double twice = 0;
    for (std::size_t i = 0; i < m_outline.size(); ++i) {
      const Place &a = m_outline[i], &b = m_outline[(i + 1) % m_outline.size()];
      twice += a[0] * b[1] - a[1] * b[0];
    }
    return twice / 2 - CGAL_PI * hole * hole;
  }

  template <class Uniform, class Along>
  static void sample_wall(double width, double side, Uniform& uniform, std::vector<Point>& points,
                          const Along& along) {
    const int n = (std::max)(1, int(std::lround(width / side))),
              m = (std::max)(1, int(std::lround(height / side)));
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < m; ++j) {
        const double t = uniform();
        const Place p = along((i + t) / n);
        points.emplace_back(p[0], p[1], (j + uniform()) / m * height);
      }
  }

  /// Returns the signed distance from the outline and the hole in the plane; negative inside.
  double signed_distance(const Place& p) const {
    double nearest = 2 * tip;
    bool is_inside = false;
    for (std::size_t i = 0; i < m_outline.size(); ++i) {
      const Place &a = m_outline[i], &b = m_outline[(i + 1) % m_outline.size()];
      const double t = ((p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1])) /
                       (length(a, b) * length(a, b)),
                   s = (std::max)(0., (std::min)(1., t));
      nearest =
          (std::min)(nearest, length(p, {{a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])}}));
      if ((a[1] > p[1]) != (b[1] > p[1]) &&
          p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
        is_inside = !is_inside;
    }
    return (std::max)(is_inside ? -nearest : nearest, hole - std::hypot(p[0], p[1]));
  }

  std::vector<Place> m_outline; // counterclockwise
};

} // namespace dsc_benchmark::clouds

#endif // DSC_BENCHMARK_GEAR_H
