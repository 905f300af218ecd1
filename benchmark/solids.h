// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_BENCHMARK_SOLIDS_H
#define DSC_BENCHMARK_SOLIDS_H

#include "inputs.h"

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

/// Solids with sharp edges, as triangles with shared points.
namespace dsc_benchmark::solids {

using Point = Kernel::Point_3;
using Outline = std::vector<std::array<double, 2>>; ///< counterclockwise; star-shaped at corner 0

/// Returns a regular polygon about the origin.
inline Outline regular_polygon(std::size_t n, double radius) {
  Outline result;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * CGAL_PI * (double(i) + .5) / double(n);
    result.push_back({{radius * std::cos(angle), radius * std::sin(angle)}});
  }
  return result;
}

/// Appends the polygon at z = 0 with downward orientation, and returns its number of corners.
inline std::size_t append_base(const Outline& outline, Surface& surface) {
  const std::size_t n = outline.size();
  for (const auto& [x, y] : outline)
    surface.points.emplace_back(x, y, 0);
  for (std::size_t i = 1; i + 1 < n; ++i)
    surface.triangles.push_back({0, i + 1, i});
  return n;
}

inline Surface prism(const Outline& outline, double height) {
  Surface result;
  const std::size_t n = append_base(outline, result);
  for (const auto& [x, y] : outline)
    result.points.emplace_back(x, y, height);
  for (std::size_t i = 1; i + 1 < n; ++i)
    result.triangles.push_back({n, n + i, n + i + 1});
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    result.triangles.push_back({i, j, n + j});
    result.triangles.push_back({i, n + j, n + i});
  }
  return result;
}

/// Returns a pyramid whose apex is above the origin.
inline Surface pyramid(const Outline& outline, double height) {
  Surface result;
  const std::size_t n = append_base(outline, result);
  result.points.emplace_back(0, 0, height);
  for (std::size_t i = 0; i < n; ++i)
    result.triangles.push_back({i, (i + 1) % n, n});
  return result;
}

/// Returns points on the edges whose triangles meet at an angle of more than 30 degrees.
inline std::vector<Point> creases(const Surface& surface) {
  static constexpr int n = 100;         // points on an edge
  static constexpr double smooth = .86; // cosine of this angle
  std::map<std::array<std::size_t, 2>, Kernel::Vector_3> normals;
  std::vector<Point> result;
  for (const auto& t : surface.triangles) {
    const auto& p = surface.points;
    const Kernel::Vector_3 across = CGAL::cross_product(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]),
                           normal = across / std::sqrt(across.squared_length());
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t v = t[k], w = t[(k + 1) % 3];
      const auto [place, is_new] =
          normals.emplace(std::array<std::size_t, 2>{{(std::min)(v, w), (std::max)(v, w)}}, normal);
      if (!is_new && place->second * normal < smooth)
        for (int i = 0; i < n; ++i)
          result.push_back(p[v] + (i + .5) / n * (p[w] - p[v]));
    }
  }
  return result;
}

} // namespace dsc_benchmark::solids

#endif // DSC_BENCHMARK_SOLIDS_H
