// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Triangle_soup_repair, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_SOUPS_SOUP_INTERSECTIONS_3_H
#define CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_SOUPS_SOUP_INTERSECTIONS_3_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Triangle_soup_3.h>

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

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
  box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    Progress_scope::check();
    if (do_cross(a.info(), b.info()))
      pairs.push_back(std::minmax({a.info(), b.info()}));
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_SOUPS_SOUP_INTERSECTIONS_3_H
