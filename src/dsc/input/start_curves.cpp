// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/start_curves.h"

#include "input/files.h"
#include "input/translations.h"
#include "programs/errors.h"

#include <CGAL/Mesh_files/labeled_curves_2.h>

namespace dsc {
namespace {

constexpr std::size_t segments_of_figures = 200;

Curve_point on_circle(const Curve_point& center, double radius, double angle) {
  return {center.x() + radius * std::cos(angle), center.y() + radius * std::sin(angle)};
}

/// Returns a regular polygon with the area of the disk that is the usual start of the single
/// vortex.
Curve disk(std::size_t segments) {
  const Curve_point center(.5, .75);
  const double radius = .15, step = 2 * CGAL_PI / double(segments);
  std::vector<Curve_point> points;
  for (std::size_t i = 0; i < segments; ++i)
    points.push_back(
        on_circle(center, radius * std::sqrt(step / std::sin(step)), double(i) * step));
  Curve curve;
  curve.add_polyline(points);
  return curve;
}

/// Returns Zalesak's disk. The vertices of the arc, except its ends, are slightly outside the
/// circle, so that the polygon has the area of the figure.
Curve slotted_disk(std::size_t segments) {
  const Curve_point center(50, 75);
  const double radius = 15, half_width = 2.5, top = 10, half_gap = std::asin(half_width / radius),
               first = half_gap - CGAL_PI / 2, whole = 2 * (CGAL_PI - half_gap),
               step = whole / double(segments);
  // The radius r of the inner vertices fulfills (n - 2) r^2 + 2 R r = R^2 n step / sin(step).
  const double a = double(segments) - 2, b = 2 * radius,
               c = -radius * radius * whole / std::sin(step);
  const double inner = (std::sqrt(b * b - 4 * a * c) - b) / (2 * a);
  std::vector<Curve_point> points;
  for (std::size_t i = 0; i <= segments; ++i)
    points.push_back(
        on_circle(center, i % segments == 0 ? radius : inner, first + double(i) * step));
  points.emplace_back(center.x() - half_width, center.y() + top);
  points.emplace_back(center.x() + half_width, center.y() + top);
  Curve curve;
  curve.add_polyline(points);
  return curve;
}

} // namespace

Curves start_curves(const Run_start& start) {
  Curves curves;
  const std::size_t segments = start.segments > 0 ? start.segments : segments_of_figures;
  if (start.inputs.empty()) {
    curves.closed.push_back(start.figure == Figure::disk ? disk(segments) : slotted_disk(segments));
    curves.names.push_back("the figure");
    return curves;
  }
  for (const std::string& input : start.inputs) {
    const std::string format = extension(input);
    if (format != "wkt" && start.inputs.size() > 1)
      throw Usage_error(input + " cannot be combined with other inputs; give it alone");
    Unused_content unused;
    if (format == "poly") {
      curves.seeded = CGAL::IO::read_seeded_segments(input, &unused);
      print_unused(input, unused);
    }
    if (format != "wkt")
      continue;
    auto read = CGAL::IO::read_labeled_curves(input, &unused);
    print_unused(input, unused);
    if (read.empty())
      throw Input_error(input + ": no geometry bounds a region; give a POLYGON or MULTIPOLYGON");
    for (Curve& curve : read) {
      curve.label = static_cast<int>(curves.closed.size()) + 1;
      curves.closed.push_back(std::move(curve));
      curves.names.push_back(input);
    }
  }
  double length = 0;
  for_each_segment(curves, [&](const Curve_point& p, const Curve_point& q) {
    length += std::sqrt(CGAL::squared_distance(p, q));
  });
  if (start.segments > 0 && length > 0) {
    for (Curve& curve : curves.closed)
      divide(length / double(start.segments), curve);
    if (curves.seeded)
      divide(length / double(start.segments), *curves.seeded);
  }
  return curves;
}

} // namespace dsc
