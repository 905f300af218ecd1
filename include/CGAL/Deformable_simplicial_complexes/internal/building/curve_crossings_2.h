// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BUILDING_CURVE_CROSSINGS_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BUILDING_CURVE_CROSSINGS_2_H

#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/internal/building/Curve_soup_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/building/label_cells.h>

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns whether two segments intersect in more than a common end. Equal segments of different
// curves are allowed.
template <class Kernel> bool meet(const Curve_soup_2& soup, const Wall<2>& s, const Wall<2>& t) {
  const auto point = [&](std::size_t i) { return soup.points[i]; };
  if (s.vertices == t.vertices)
    return s.surface == t.surface;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      if (s.vertices[i] == t.vertices[j]) {
        const auto p = point(s.vertices[i]), a = point(s.vertices[1 - i]),
                   b = point(t.vertices[1 - j]);
        return CGAL::collinear(p, a, b) &&
               !CGAL::collinear_are_strictly_ordered_along_line(a, p, b);
      }
  using Segment = typename Kernel::Segment_2;
  return CGAL::do_intersect(Segment(point(s.vertices[0]), point(s.vertices[1])),
                            Segment(point(t.vertices[0]), point(t.vertices[1])));
}

// Throws `Invalid_surface_error` if segments cross or overlap. Complexity: O(n log n) if few
// bounding boxes of segments overlap.
template <class Kernel> void check_crossings(const Curve_soup_2& soup) {
  using Box = Box_intersection_d::Box_with_info_d<double, 2, std::size_t>;
  using Reason = Invalid_surface_error::Reason;
  std::vector<Box> boxes;
  for (std::size_t w = 0; w < soup.walls.size(); ++w) {
    const auto& v = soup.walls[w].vertices;
    boxes.emplace_back(soup.points[v[0]].bbox() + soup.points[v[1]].bbox(), w);
  }
  std::vector<std::pair<std::size_t, std::size_t>> crossings;
  box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    Progress_scope::check();
    if (meet<Kernel>(soup, soup.walls[a.info()], soup.walls[b.info()]))
      crossings.push_back(std::minmax(a.info(), b.info()));
  });
  if (crossings.empty())
    return;
  std::sort(crossings.begin(), crossings.end());
  const auto curve = [&](std::size_t wall) { return soup.walls[wall].surface; };
  const std::size_t first = curve(crossings[0].first), second = curve(crossings[0].second);
  std::vector<std::size_t> segments;
  for (const auto& [a, b] : crossings)
    if (curve(a) == first && curve(b) == second)
      segments.insert(segments.end(), {soup.segments[a], soup.segments[b]});
  const std::string place =
      " at its segment from " + text_of(soup.points[soup.walls[crossings[0].first].vertices[0]]) +
      " to " + text_of(soup.points[soup.walls[crossings[0].first].vertices[1]]);
  if (first == second)
    refuse_curve(Reason::self_intersection,
                 "intersects itself" + place + ": segments may meet only in common ends", first,
                 second, std::move(segments));
  refuse_curve(Reason::crossing_surfaces,
               "intersects curve " + std::to_string(second) + place +
                   ": curves may be nested and may share whole segments or their ends, but must "
                   "not cross or overlap in parts of segments",
               first, second, std::move(segments));
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BUILDING_CURVE_CROSSINGS_2_H
