// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_REPAIR_SPLIT_AT_T_JUNCTIONS_3_H
#define CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_REPAIR_SPLIT_AT_T_JUNCTIONS_3_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Triangle_soup_3.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Splits open edges at the ends of other open edges that lie on them, within a tolerance. An edge
// is open if its number of triangles is odd. The triangles of split edges are triangulated again.
// Points do not move.
class T_junction_splitter_3
{
public:
  explicit T_junction_splitter_3(Triangle_soup_3& soup) : m_soup(soup) {}

  // Splits the edges. Returns the number of split edges.
  std::size_t run() {
    collect_open_edges();
    collect_points_on_edges();
    for (auto& [edge, points] : m_points)
      std::sort(points.begin(), points.end());
    if (!m_points.empty())
      split_triangles();
    return m_points.size();
  }

private:
  using Edge = std::array<std::size_t, 2>;              // indices in increasing order
  using Point_on_edge = std::pair<double, std::size_t>; // parameter in [0, 1], and the vertex
  using Point = Predicates_kernel::Point_3;

  // A vertex is on an edge if its distance is less than this fraction of the edge, and of the
  // shortest open edge at the vertex. The tolerance exceeds the rounding of coordinates with six
  // digits.
  static constexpr double tolerance = 1e-3;

  Point point(std::size_t v) const { return exact_point(m_soup.points[v]); }

  void collect_open_edges() {
    for_each_edge(sorted_sides(m_soup.triangles), [&](auto side, std::size_t number) {
      if (number % 2 == 0)
        return;
      m_edges.push_back(side->vertices);
      const double length =
          std::sqrt(squared_distance(point(side->vertices[0]), point(side->vertices[1])));
      for (std::size_t v : side->vertices) {
        double& shortest = m_shortest.emplace(v, length).first->second;
        shortest = (std::min)(shortest, length);
      }
    });
  }

  void collect_points_on_edges() {
    using Box = Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;
    std::vector<Box> edges, vertices;
    for (std::size_t e = 0; e < m_edges.size(); ++e)
      edges.emplace_back(point(m_edges[e][0]).bbox() + point(m_edges[e][1]).bbox(), e);
    for (const auto& [v, shortest] : m_shortest) {
      const Coordinates_3& p = m_soup.points[v];
      const double r = tolerance * shortest;
      vertices.emplace_back(Bbox_3(p[0] - r, p[1] - r, p[2] - r, p[0] + r, p[1] + r, p[2] + r), v);
    }
    box_intersection_d(edges.begin(), edges.end(), vertices.begin(), vertices.end(),
                       [&](const Box& e, const Box& v) {
                         Progress_scope::check();
                         add_if_near(m_edges[e.info()], v.info());
                       });
  }

  void add_if_near(const Edge& edge, std::size_t v) {
    if (v == edge[0] || v == edge[1])
      return;
    const auto along = point(edge[1]) - point(edge[0]), to_point = point(v) - point(edge[0]);
    const double squared_length = along.squared_length();
    const double place = along * to_point / squared_length;
    const double limit = tolerance * (std::min)(m_shortest.at(v), std::sqrt(squared_length));
    if (place > tolerance && place < 1 - tolerance &&
        (to_point - place * along).squared_length() < limit * limit)
      m_points[edge].emplace_back(place, v);
  }

  // Returns the points on the side between two corners of a triangle, in the direction from the
  // first to the second corner.
  std::vector<std::size_t> points_between(std::size_t a, std::size_t b) const {
    std::vector<std::size_t> result;
    const auto found = m_points.find({(std::min)(a, b), (std::max)(a, b)});
    if (found != m_points.end())
      for (const auto& [place, v] : found->second)
        result.push_back(v);
    if (a > b)
      std::reverse(result.begin(), result.end());
    return result;
  }

  // Replaces each triangle with points on an edge by a fan around the opposite corner. The first
  // and the last triangle of the fan may have points on their edges, too. A point that is a corner
  // of the triangle is skipped.
  void split_triangles() {
    std::vector<Triangle_indices> todo(m_soup.triangles.rbegin(), m_soup.triangles.rend()), done;
    while (!todo.empty()) {
      Progress_scope::check();
      const Triangle_indices t = todo.back();
      todo.pop_back();
      if (!split(t, todo))
        done.push_back(t);
    }
    m_soup.triangles = std::move(done);
  }

  bool split(const Triangle_indices& t, std::vector<Triangle_indices>& todo) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
      auto points = points_between(a, b);
      points.erase(std::remove(points.begin(), points.end(), c), points.end());
      if (points.empty())
        continue;
      points.push_back(b);
      std::size_t last = a;
      for (std::size_t p : points) {
        todo.push_back({last, p, c});
        last = p;
      }
      return true;
    }
    return false;
  }

  Triangle_soup_3& m_soup;
  std::vector<Edge> m_edges;                // open edges
  std::map<std::size_t, double> m_shortest; // length of the shortest open edge at each vertex
  std::map<Edge, std::vector<Point_on_edge>> m_points;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_REPAIR_SPLIT_AT_T_JUNCTIONS_3_H
