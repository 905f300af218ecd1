// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_CURVES_CHECK_RINGS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_CURVES_CHECK_RINGS_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A ring of one of several polygons: the boundary of the polygon or of a hole.
struct Polygon_ring
{
  std::vector<std::array<double, 2>> points;
  std::size_t polygon;
  bool is_hole;
  std::size_t line; // of the file
};

// The nesting of rings: for each ring, the number of rings that contain it, tested at one point of
// the ring. The algorithm sorts these points by y-coordinate. Complexity: O(n log n) if the
// y-ranges of few rings overlap.
class Ring_nesting
{
public:
  explicit Ring_nesting(const std::vector<Polygon_ring>& rings)
      : m_rings(rings), m_depths(rings.size(), 0), m_is_in_shell(rings.size(), false) {
    for (std::size_t r = 0; r < rings.size(); ++r) {
      const auto &a = rings[r].points[0], &b = rings[r].points[1];
      m_places.push_back({(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, r});
    }
    std::sort(m_places.begin(), m_places.end(),
              [](const Place& a, const Place& b) { return a.y < b.y; });
    for (std::size_t r = 0; r < rings.size(); ++r)
      count_inside(r);
  }

  // Returns the number of other rings that contain a ring.
  std::size_t depth(std::size_t ring) const { return m_depths[ring]; }

  // Returns whether a ring lies inside the outer boundary of its polygon.
  bool is_in_shell(std::size_t ring) const { return m_is_in_shell[ring]; }

private:
  struct Place
  {
    double x, y;
    std::size_t ring;
  };

  // Increments the depth of all rings that lie inside a ring. A point lies inside if its ray to the
  // right crosses the ring an odd number of times.
  void count_inside(std::size_t around) {
    const auto& points = m_rings[around].points;
    std::vector<std::size_t> crossed; // rings whose rays cross `around`, once for each crossing
    for (std::size_t i = 0; i < points.size(); ++i) {
      auto low = points[i], high = points[(i + 1) % points.size()];
      if (low[1] > high[1])
        std::swap(low, high);
      const auto is_below = [](const Place& p, double y) { return p.y < y; };
      auto place = std::lower_bound(m_places.begin(), m_places.end(), low[1], is_below);
      for (; place != m_places.end() && place->y < high[1]; ++place)
        if (place->ring != around && is_left(*place, low, high))
          crossed.push_back(place->ring);
    }
    std::sort(crossed.begin(), crossed.end());
    for (auto first = crossed.begin(); first != crossed.end();) {
      const auto last = std::upper_bound(first, crossed.end(), *first);
      if ((last - first) % 2 != 0) {
        ++m_depths[*first];
        if (!m_rings[around].is_hole && m_rings[around].polygon == m_rings[*first].polygon)
          m_is_in_shell[*first] = true;
      }
      first = last;
    }
  }

  static bool is_left(const Place& p, const std::array<double, 2>& low,
                      const std::array<double, 2>& high) {
    using Point = Exact_predicates_inexact_constructions_kernel::Point_2;
    return CGAL::orientation(Point(low[0], low[1]), Point(high[0], high[1]), Point(p.x, p.y)) ==
           LEFT_TURN;
  }

  const std::vector<Polygon_ring>& m_rings;
  std::vector<Place> m_places; // one point of each ring, sorted by y-coordinate
  std::vector<std::size_t> m_depths;
  std::vector<bool> m_is_in_shell;
};

// A ring and a description of its fault.
struct Ring_fault
{
  std::size_t ring;
  const char* what;
};

// Returns the first hole that is not inside its polygon, or the first polygon that overlaps another
// one, if any.
// \pre Rings do not cross. Crossings are detected later, by the triangulation of the plane.
inline std::optional<Ring_fault> find_ring_fault(const std::vector<Polygon_ring>& rings) {
  const Ring_nesting nesting(rings);
  for (std::size_t r = 0; r < rings.size(); ++r) {
    if (rings[r].is_hole && !nesting.is_in_shell(r))
      return Ring_fault{r, "a hole is outside its polygon: the first ring of a polygon is its "
                           "boundary, and the others are holes; correct their order"};
    if (rings[r].is_hole && nesting.depth(r) % 2 == 0)
      return Ring_fault{r, "a hole is inside another hole, or in a polygon that overlaps another "
                           "one: write polygons inside holes as separate polygons"};
    if (!rings[r].is_hole && nesting.depth(r) % 2 != 0)
      return Ring_fault{r, "a polygon is inside another one of the same geometry: unite them, make "
                           "it a hole, or make it a separate geometry"};
  }
  return std::nullopt;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_CURVES_CHECK_RINGS_H
