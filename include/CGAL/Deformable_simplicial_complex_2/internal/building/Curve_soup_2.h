// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_BUILDING_CURVE_SOUP_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_BUILDING_CURVE_SOUP_2_H

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/internal/building/label_cells.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

using Planar_kernel = Exact_predicates_inexact_constructions_kernel;

// All curves together: their points, equal ones merged, and the segments as walls.
struct Curve_soup_2
{
  std::vector<Planar_kernel::Point_2> points;
  std::vector<Wall<2>> walls;
  std::vector<std::size_t> segments;                   // of the curve that a wall is of
  std::map<std::array<double, 2>, std::size_t> places; // of points, by coordinates
};

[[noreturn]] inline void refuse_curve(Invalid_surface_error::Reason reason,
                                      const std::string& explanation, std::size_t curve,
                                      std::size_t other, std::vector<std::size_t> segments,
                                      std::vector<std::size_t> vertices = {}) {
  std::string message = "curve " + std::to_string(curve) + ' ' + explanation;
  if (!segments.empty())
    message += " (first segment: " + std::to_string(segments.front()) + ')';
  else if (!vertices.empty())
    message += " (first vertex: " + std::to_string(vertices.front()) + ')';
  throw Invalid_surface_error(reason, message, curve, std::move(segments), std::move(vertices),
                              other);
}

// Adds the segments of a curve. Refuses what has none, and numbers that are none.
template <class Curve>
void add_segments(const Curve& curve, std::size_t number, Curve_soup_2& soup) {
  using Reason = Invalid_surface_error::Reason;
  const auto refuse = [&](Reason reason, const char* explanation, std::size_t segment) {
    refuse_curve(reason, explanation, number, number, {segment});
  };
  if (curve.segments.empty())
    refuse_curve(Reason::empty, "has no segments: give some", number, number, {});
  for (std::size_t s = 0; s < curve.segments.size(); ++s) {
    std::array<std::size_t, 2> ends;
    for (int i = 0; i < 2; ++i) {
      if (curve.segments[s][i] >= curve.points.size())
        refuse(Reason::bad_index, "has segments with ends that do not exist: correct these indices",
               s);
      const auto& p = curve.points[curve.segments[s][i]];
      const std::array<double, 2> q = {to_double(p.x()) + 0., to_double(p.y()) + 0.};
      if (!std::isfinite(q[0]) || !std::isfinite(q[1]))
        refuse(Reason::not_finite, "has coordinates that are no finite numbers: correct them", s);
      const auto place = soup.places.emplace(q, soup.points.size());
      if (place.second)
        soup.points.emplace_back(q[0], q[1]);
      ends[i] = place.first->second;
    }
    if (ends[0] == ends[1])
      refuse(Reason::degenerate_facet, "has segments without length: remove them", s);
    soup.walls.push_back(make_wall(ends, number));
    soup.segments.push_back(s);
  }
}

// Adds a closed curve; refuses open ones, too.
template <class Curve> void add_curve(const Curve& curve, std::size_t number, Curve_soup_2& soup) {
  const std::size_t first = soup.walls.size();
  add_segments(curve, number, soup);
  std::map<std::size_t, std::vector<std::size_t>> segments_at; // by point, of this curve
  for (std::size_t w = first; w < soup.walls.size(); ++w)
    for (std::size_t v : soup.walls[w].vertices)
      segments_at[v].push_back(soup.segments[w]);
  for (const auto& [point, segments] : segments_at)
    if (segments.size() % 2 != 0)
      refuse_curve(segments.size() == 1 ? Invalid_surface_error::Reason::open
                                        : Invalid_surface_error::Reason::non_manifold_edge,
                   segments.size() == 1
                       ? "is not closed: join its ends"
                       : "has a point where an odd number of its segments end: make it closed "
                         "curves, or use segments with seeds",
                   number, number, {segments.front()});
}

// Whether two segments have more in common than ends, or all that they are.
inline bool meet(const Curve_soup_2& soup, const Wall<2>& s, const Wall<2>& t) {
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
  return CGAL::do_intersect(Planar_kernel::Segment_2(point(s.vertices[0]), point(s.vertices[1])),
                            Planar_kernel::Segment_2(point(t.vertices[0]), point(t.vertices[1])));
}

// Refuses segments that cross or overlap others. n log n, if few boxes around them overlap.
inline void check_crossings(const Curve_soup_2& soup) {
  using Box = Box_intersection_d::Box_with_info_d<double, 2, std::size_t>;
  using Reason = Invalid_surface_error::Reason;
  std::vector<Box> boxes;
  for (std::size_t w = 0; w < soup.walls.size(); ++w) {
    const auto& v = soup.walls[w].vertices;
    boxes.emplace_back(soup.points[v[0]].bbox() + soup.points[v[1]].bbox(), w);
  }
  std::vector<std::pair<std::size_t, std::size_t>> crossings;
  box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    if (meet(soup, soup.walls[a.info()], soup.walls[b.info()]))
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
  if (first == second)
    refuse_curve(Reason::self_intersection,
                 "crosses or overlaps itself: segments may meet in common ends only", first, second,
                 std::move(segments));
  refuse_curve(
      Reason::crossing_surfaces,
      "meets another curve: they may be nested, touch in common ends of segments, and have "
      "whole segments in common, but not cross or overlap in parts",
      first, second, std::move(segments));
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_BUILDING_CURVE_SOUP_2_H
