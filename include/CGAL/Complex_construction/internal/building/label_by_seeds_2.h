// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Complex_construction, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_LABEL_BY_SEEDS_2_H
#define CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_LABEL_BY_SEEDS_2_H

#include <CGAL/Complex_construction/Labeled_curve_2.h>
#include <CGAL/Complex_construction/internal/building/Planar_filling_2.h>
#include <CGAL/Complex_construction/internal/building/label_cells.h>
#include <CGAL/Mesh_support/Error.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <locale>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns a triangle incident to a corner of the box.
inline std::size_t triangle_on_box(const Planar_filling_2& filling) {
  const auto corner = std::size_t(std::min_element(filling.points.begin(), filling.points.end()) -
                                  filling.points.begin());
  return std::size_t(std::find_if(filling.triangles.begin(), filling.triangles.end(),
                                  [&](const std::array<std::size_t, 3>& t) {
                                    return std::find(t.begin(), t.end(), corner) != t.end();
                                  }) -
                     filling.triangles.begin());
}

// Returns the labels of the triangles that fill a box, given by seed points in its regions. Throws
// `Error` if a seed is invalid, or if two seeds of a region have different labels.
template <class Point>
std::vector<int> label_by_seeds(const Seeded_segments_2<Point>& segments, const Curve_soup_2& soup,
                                const Planar_filling_2& filling) {
  const auto refuse = [&](std::size_t seed, const char* what) {
    const auto& p = segments.seeds[seed].first;
    std::ostringstream message;
    message.imbue(std::locale::classic());
    message << "seed " << seed << ", at (" << to_double(p.x()) << ", " << to_double(p.y()) << "), "
            << what;
    throw Error(message.str());
  };
  std::vector<std::pair<std::size_t, int>> triangles;
  for (std::size_t i = 0; i < segments.seeds.size(); ++i) {
    const auto& [point, label] = segments.seeds[i];
    const Planar_filling_2::Point p(to_double(point.x()), to_double(point.y()));
    if (!std::isfinite(p.x()) || !std::isfinite(p.y()))
      refuse(i, "has coordinates that are not finite: correct them");
    const Planar_filling_2::Place place = filling.locate(p);
    if (!place.triangle)
      refuse(i, "is outside the enclosing box: give a larger box");
    if (place.is_on_segment)
      refuse(i, "is on a segment: choose a point within its region");
    triangles.emplace_back(*place.triangle, label);
  }
  std::optional<Contradicting_seeds> contradicting;
  auto labels = label_cells_by_seeds<2>(filling.triangles, soup.walls, triangles, contradicting);
  if (contradicting)
    refuse(contradicting->second,
           "is in the region of another seed with another label: are segments missing "
           "between them?");
  if (segments.enclosed_label != 0) {
    for (auto& triangle : triangles)
      triangle.second = 1;
    triangles.emplace_back(triangle_on_box(filling), 1);
    const auto is_told =
        label_cells_by_seeds<2>(filling.triangles, soup.walls, triangles, contradicting);
    for (std::size_t t = 0; t < labels.size(); ++t)
      if (is_told[t] == 0)
        labels[t] = segments.enclosed_label;
  }
  return labels;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_LABEL_BY_SEEDS_2_H
