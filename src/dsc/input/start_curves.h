// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_START_CURVES_H
#define DSC_START_CURVES_H

#include "input/run_start.h"

#include <CGAL/Complex_construction/Labeled_curve_2.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>

namespace dsc {

using Curve_point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
using Curve = DSC::Labeled_curve_2<Curve_point>;

/// The initial division of the plane: closed curves, or segments with seeds.
struct Curves
{
  std::vector<Curve> closed;
  std::vector<std::string> names; ///< names of the curves, for messages
  std::optional<DSC::Seeded_segments_2<Curve_point>> seeded;
};

/// Returns the initial curves of a run: the curves of its files or, without files, of its figure;
/// none if the run starts from an image.
/// \throws std::runtime_error if a file cannot be read
Curves start_curves(const Run_start& start);

/// Calls f(p, q) for the ends of all segments.
template <class Function> void for_each_segment(const Curves& curves, const Function& f) {
  for (const auto& curve : curves.closed)
    for (const auto& [a, b] : curve.segments)
      f(curve.points[a], curve.points[b]);
  if (curves.seeded)
    for (const auto& [a, b] : curves.seeded->segments)
      f(curves.seeded->points[a], curves.seeded->points[b]);
}

/// Divides segments so that none is longer than a bound.
template <class Segments> void divide(double longest, Segments& curve) {
  std::vector<std::array<std::size_t, 2>> parts;
  for (const auto& [a, b] : curve.segments) {
    const Curve_point p = curve.points[a], q = curve.points[b];
    const double length = std::sqrt(CGAL::squared_distance(p, q));
    const auto n = std::max<std::size_t>(1, std::size_t(std::ceil(length / longest)));
    std::size_t last = a;
    for (std::size_t i = 1; i < n; ++i) {
      curve.points.push_back(p + double(i) / double(n) * (q - p));
      parts.push_back({last, curve.points.size() - 1});
      last = curve.points.size() - 1;
    }
    parts.push_back({last, b});
  }
  curve.segments = parts;
}

} // namespace dsc

#endif // DSC_START_CURVES_H
