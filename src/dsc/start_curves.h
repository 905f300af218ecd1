// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_START_CURVES_H
#define DSC_START_CURVES_H

#include "run_start.h"

#include <CGAL/Deformable_simplicial_complexes/Labelled_curve_2.h>
#include <CGAL/Deformable_simplicial_complexes/Seeded_segments_2.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <optional>
#include <string>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc {

using Curve_point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;

/// The initial division of the plane: closed curves, or segments with seeds.
struct Curves
{
  std::vector<DSC::Labelled_curve_2<Curve_point>> closed;
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

} // namespace dsc

#endif // DSC_START_CURVES_H
