// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_CURVE_SOUP_2_H
#define CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_CURVE_SOUP_2_H

#include <CGAL/Complex_construction/internal/building/label_cells.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangle_soup_repair/Invalid_surface_error.h>

#include <cmath>
#include <locale>
#include <map>
#include <sstream>

namespace CGAL::Deformable_simplicial_complexes::internal {

using Planar_kernel = Exact_predicates_inexact_constructions_kernel;

// The union of all curves: points, of which equal ones are merged, and segments as walls.
struct Curve_soup_2
{
  std::vector<Planar_kernel::Point_2> points;
  std::vector<Wall<2>> walls;
  std::vector<std::size_t> segments; // for each wall, the index of the segment in its curve
  std::map<std::array<double, 2>, std::size_t> places; // indices of points, by coordinates
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

// Returns a point as text for messages.
inline std::string text_of(const Planar_kernel::Point_2& p) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << '(' << p.x() << ", " << p.y() << ')';
  return text.str();
}

// Adds the segments of a curve. Throws `Invalid_surface_error` if there are none, if an index does
// not exist, if a coordinate is not finite, or if a segment has length zero.
template <class Curve>
void add_segments(const Curve& curve, std::size_t number, Curve_soup_2& soup) {
  using Reason = Invalid_surface_error::Reason;
  const auto refuse = [&](Reason reason, const char* explanation, std::size_t segment) {
    refuse_curve(reason, explanation, number, number, {segment});
  };
  if (curve.segments.empty())
    refuse_curve(Reason::empty, "has no segments: give at least one", number, number, {});
  for (std::size_t s = 0; s < curve.segments.size(); ++s) {
    std::array<std::size_t, 2> ends;
    for (int i = 0; i < 2; ++i) {
      if (curve.segments[s][i] >= curve.points.size())
        refuse(Reason::bad_index, "has segments whose ends do not exist: correct these indices", s);
      const auto& p = curve.points[curve.segments[s][i]];
      const std::array<double, 2> q = {to_double(p.x()) + 0., to_double(p.y()) + 0.};
      if (!std::isfinite(q[0]) || !std::isfinite(q[1]))
        refuse(Reason::not_finite, "has coordinates that are not finite: correct them", s);
      const auto place = soup.places.emplace(q, soup.points.size());
      if (place.second)
        soup.points.emplace_back(q[0], q[1]);
      ends[i] = place.first->second;
    }
    if (ends[0] == ends[1])
      refuse(Reason::degenerate_facet, "has segments of length zero: remove them", s);
    soup.walls.push_back(make_wall(ends, number));
    soup.segments.push_back(s);
  }
}

// Adds a closed curve. Throws `Invalid_surface_error` also if an odd number of segments end in a
// point.
template <class Curve> void add_curve(const Curve& curve, std::size_t number, Curve_soup_2& soup) {
  const std::size_t first = soup.walls.size();
  add_segments(curve, number, soup);
  std::map<std::size_t, std::vector<std::size_t>> segments_at; // by point, for this curve only
  for (std::size_t w = first; w < soup.walls.size(); ++w)
    for (std::size_t v : soup.walls[w].vertices)
      segments_at[v].push_back(soup.segments[w]);
  for (const auto& [point, segments] : segments_at)
    if (segments.size() % 2 != 0)
      refuse_curve(
          segments.size() == 1 ? Invalid_surface_error::Reason::open
                               : Invalid_surface_error::Reason::non_manifold_edge,
          (segments.size() == 1
               ? "is not closed: it ends at " + text_of(soup.points[point]) + "; join its ends"
               : "has a point with an odd number of segments, " + text_of(soup.points[point]) +
                     ": use closed curves, or segments with seeds"),
          number, number, {segments.front()});
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_CURVE_SOUP_2_H
