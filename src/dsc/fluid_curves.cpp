// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluid_curves.h"

#include "fluid_shapes.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace dsc {

Curve curve_of(const Ball_shape& disk, double edge) {
  static constexpr std::size_t least = 8;
  const std::size_t n = std::max(least, number_of_parts(2 * CGAL_PI * disk.radius / edge));
  const double step = 2 * CGAL_PI / double(n),
               radius = disk.radius * std::sqrt(step / std::sin(step));
  std::vector<Curve_point> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = double(i) * step,
                 r = radius *
                     (1 +
                      (disk.mode > 0 ? disk.amplitude * std::cos(double(disk.mode) * angle) : 0));
    points.emplace_back(disk.center[0] + r * std::cos(angle), disk.center[1] + r * std::sin(angle));
  }
  Curve curve;
  curve.add_polyline(points);
  return curve;
}

namespace {

/// Moves and scales a curve, so that it touches a disk from inside. The center of its bounding box
/// is moved to the center of the disk.
void fit(Curve& curve, const Ball& disk) {
  CGAL::Bbox_2 box;
  for (const Curve_point& p : curve.points)
    box += p.bbox();
  const Curve_point middle((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2);
  double farthest = 0;
  for (const Curve_point& p : curve.points)
    farthest = std::max(farthest, CGAL::squared_distance(p, middle));
  const double scale = disk.radius / std::sqrt(farthest);
  for (Curve_point& p : curve.points)
    p = Curve_point(disk.center[0], disk.center[1]) + scale * (p - middle);
}

} // namespace

Curve curve_of(const File_shape& shape, const std::string& path, double edge) {
  Run_start start;
  start.inputs = {path};
  Curve result;
  for (const Curve& curve : start_curves(start).closed) {
    const std::size_t first = result.points.size();
    result.points.insert(result.points.end(), curve.points.begin(), curve.points.end());
    for (const auto& [a, b] : curve.segments)
      result.segments.push_back({first + a, first + b});
  }
  fit(result, shape.ball);
  number_of_parts(double(result.segments.size()) * shape.ball.radius / edge);
  divide(edge, result);
  return result;
}

} // namespace dsc
