// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_SOUPS_SOUP_INTERSECTIONS_3_H
#define CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_SOUPS_SOUP_INTERSECTIONS_3_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Triangle_soup_3.h>

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/enum.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Orders the triangles at an edge by their angle around the edge, starting with a given triangle.
// Exact.
// \pre no two triangles overlap
class Less_around_edge_3
{
public:
  Less_around_edge_3(const Triangle_soup_3& soup, const Triangle_side& first)
      : m_soup(soup), m_first(first) {}

  bool operator()(const Triangle_side& a, const Triangle_side& b) const {
    const int part_of_a = part(a), part_of_b = part(b);
    return part_of_a != part_of_b ? part_of_a < part_of_b : turn(a, b) == POSITIVE;
  }

private:
  // Returns the part of the full angle in which a triangle lies: the start, the first half, the
  // opposite direction, or the second half.
  int part(const Triangle_side& side) const {
    if (side.triangle == m_first.triangle)
      return 0;
    const Orientation o = turn(m_first, side);
    return o == POSITIVE ? 1 : o == COPLANAR ? 2 : 3;
  }

  Orientation turn(const Triangle_side& a, const Triangle_side& b) const {
    return orientation(point(m_first.vertices[0]), point(m_first.vertices[1]),
                       point(a.opposite_vertex), point(b.opposite_vertex));
  }

  Predicates_kernel::Point_3 point(std::size_t i) const { return exact_point(m_soup.points[i]); }

  const Triangle_soup_3& m_soup;
  Triangle_side m_first;
};

// Returns the pairs of triangles of different surfaces that cross in a common edge, the smaller
// index first; sorted.
//
// Surfaces touch in an edge, without crossing, if the cyclic sequence of triangles around the edge
// becomes empty when neighbors of the same surface are removed repeatedly, like matching brackets.
// \pre triangles meet in common vertices and edges only, and each surface has an even number of
// triangles in each edge
inline std::vector<std::pair<std::size_t, std::size_t>>
crossings_at_edges(const Joined_soup_3& soup) {
  const auto surface = [&soup](const Triangle_side& side) {
    return soup.triangle_origins[side.triangle].surface;
  };
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  std::vector<Triangle_side> sides = sorted_sides(soup.triangles), unmatched;
  for (auto side = sides.begin(); side != sides.end();) {
    const auto end = sides.begin() + (end_of_edge(side, sides.end()) - sides.cbegin());
    if (surface(*side) != surface(*(end - 1))) {
      std::sort(side, end, Less_around_edge_3(soup, *side));
      unmatched.clear();
      for (; side != end; ++side)
        if (!unmatched.empty() && surface(unmatched.back()) == surface(*side))
          unmatched.pop_back();
        else
          unmatched.push_back(*side);
      auto first = unmatched.begin(), last = unmatched.end();
      for (; first != last && surface(*first) == surface(*(last - 1)); ++first)
        --last; // neighbors across the start of the cycle
      for (; first != last && first + 1 != last; ++first)
        pairs.push_back(std::minmax({first->triangle, (first + 1)->triangle}));
    }
    side = end;
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

// Tests whether two triangles of a soup intersect anywhere except in a common vertex or a common
// edge. Exact.
//
// Works on a soup, not on a halfedge mesh as Polygon_mesh_processing does, because
// self-intersecting surfaces may have no consistent orientation.
// \pre no triangle is degenerate, and points with different indices differ
template <class Kernel> class Do_triangles_cross_3
{
public:
  explicit Do_triangles_cross_3(const Triangle_soup_3& soup) : m_soup(soup) {}

  bool operator()(std::size_t s, std::size_t t) const {
    // Moves common vertices to the front of both triangles.
    Triangle_indices a = m_soup.triangles[s], b = m_soup.triangles[t];
    std::size_t n = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto found = std::find(b.begin() + n, b.end(), a[i]);
      if (found != b.end()) {
        std::swap(*found, b[n]);
        std::swap(a[i], a[n]);
        ++n;
      }
    }
    switch (n) {
    case 0:
      return do_intersect(exact_triangle(m_soup, s), exact_triangle(m_soup, t));
    case 1:
      return do_intersect(opposite_edge(a), exact_triangle(m_soup, t)) ||
             do_intersect(opposite_edge(b), exact_triangle(m_soup, s));
    case 2: {
      // With a common edge, the triangles intersect if they are coplanar and on the same side of
      // it.
      const auto p = point(a[0]), q = point(a[1]), r = point(a[2]), o = point(b[2]);
      return coplanar(p, q, r, o) && coplanar_orientation(p, q, r, o) == POSITIVE;
    }
    default:
      return true;
    }
  }

private:
  typename Kernel::Point_3 point(std::size_t i) const { return exact_point(m_soup.points[i]); }
  typename Kernel::Segment_3 opposite_edge(const Triangle_indices& t) const {
    return {point(t[1]), point(t[2])};
  }

  const Triangle_soup_3& m_soup;
};

// Returns all pairs of triangles of a soup that intersect anywhere except in a common vertex or a
// common edge, the smaller index first; sorted. Exact.
// \pre no triangle is degenerate, and points with different indices differ
template <class Kernel = Predicates_kernel>
std::vector<std::pair<std::size_t, std::size_t>> crossing_triangles(const Triangle_soup_3& soup) {
  using Box = Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;
  std::vector<Box> boxes;
  boxes.reserve(soup.triangles.size());
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    boxes.emplace_back(exact_triangle(soup, t).bbox(), t);

  const Do_triangles_cross_3<Kernel> do_cross(soup);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  box_self_intersection_d(
      boxes.begin(), boxes.end(),
      [&](const Box& a, const Box& b) {
        Progress_scope::check();
        if (do_cross(a.info(), b.info()))
          pairs.push_back(std::minmax({a.info(), b.info()}));
      },
      undivided_boxes);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_SOUPS_SOUP_INTERSECTIONS_3_H
