// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_ARRANGEMENT_FLAT_SIMPLIFIER_3_H
#define CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_ARRANGEMENT_FLAT_SIMPLIFIER_3_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Triangle_soup_3.h>
#include <CGAL/Triangle_soup_repair/internal/soups/soup_intersections_3.h>

#include <iterator>
#include <limits>
#include <set>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Triangles between labels.
struct Walls_3 : Triangle_soup_3
{
  std::vector<std::array<int, 2>> labels; // behind and in front of each triangle
  std::vector<double> lengths;            // of an edge of the surface that contains each triangle
};

// Removes needles from walls where their shape does not depend on them. Where two surfaces divide a
// flat wall differently, the triangles of both have edges of any length.
//
// A vertex is moved to a near neighbor if all triangles at it stay in their planes, up to a
// distance, and lines between different walls stay where they are. Then edges between triangles of
// a wall in one plane are flipped until these are Delaunay triangulations.
class Flat_simplifier_3
{
public:
  // \param distance distance that vertices may be off the plane of a triangle
  Flat_simplifier_3(const Walls_3& walls, double distance)
      : m_soup(walls), m_distance(distance), m_triangles_at(walls.points.size()),
        m_is_alive(walls.triangles.size(), 1) {
    for (std::size_t t = 0; t < walls.triangles.size(); ++t)
      for (std::size_t v : walls.triangles[t])
        m_triangles_at[v].push_back(t);
  }

  void run() {
    collapse_short_edges();
    flip_edges();
  }

  // Returns the walls. Triangles that are removed do not change the order of the others.
  Walls_3 result() const {
    Walls_3 result;
    result.points = m_soup.points;
    for (std::size_t t = 0; t < m_is_alive.size(); ++t)
      if (m_is_alive[t]) {
        result.triangles.push_back(m_soup.triangles[t]);
        result.labels.push_back(m_soup.labels[t]);
        result.lengths.push_back(m_soup.lengths[t]);
      }
    return result;
  }

private:
  using Kernel = Predicates_kernel;
  using Point = Kernel::Point_3;
  using Vector = Kernel::Vector_3;
  using Edge = std::array<std::size_t, 2>;

  static constexpr double short_edge = .2;   // beside edges of the surfaces
  static constexpr double least_height = .5; // after a collapse, beside that before
  static constexpr double flip_gain = 1e-9;  // in half turns; more than rounding
  static constexpr int most_flips = 20;      // of each edge, on average; a few are usual

  Point point(std::size_t v) const { return exact_point(m_soup.points[v]); }

  Vector normal(const Triangle_indices& t) const {
    return cross_product(point(t[1]) - point(t[0]), point(t[2]) - point(t[0]));
  }

  static bool has(const Triangle_indices& t, std::size_t v) {
    return std::find(t.begin(), t.end(), v) != t.end();
  }

  // Returns the neighbors of a vertex, in increasing order.
  std::vector<std::size_t> neighbors(std::size_t v) const {
    std::vector<std::size_t> result;
    for (std::size_t t : m_triangles_at[v])
      for (std::size_t w : m_soup.triangles[t])
        if (w != v)
          result.push_back(w);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  std::vector<std::size_t> triangles_at(std::size_t v, std::size_t w) const {
    std::vector<std::size_t> result;
    for (std::size_t t : m_triangles_at[v])
      if (has(m_soup.triangles[t], w))
        result.push_back(t);
    return result;
  }

  // Returns whether an edge is a line between walls, or the boundary of one.
  bool is_line(std::size_t v, std::size_t w) const {
    const auto triangles = triangles_at(v, w);
    return triangles.size() != 2 || m_soup.labels[triangles[0]] != m_soup.labels[triangles[1]];
  }

  // Moves vertices with short edges to neighbors until there are no such vertices.
  void collapse_short_edges() {
    std::vector<double> lengths(m_triangles_at.size(), 0);
    std::set<std::size_t> todo;
    for (std::size_t v = 0; v < m_triangles_at.size(); ++v)
      for (std::size_t t : m_triangles_at[v]) {
        lengths[v] = (std::max)(lengths[v], m_soup.lengths[t]);
        todo.insert(todo.end(), v);
      }
    while (!todo.empty()) {
      Progress_scope::check();
      const std::size_t v = *todo.begin();
      todo.erase(todo.begin());
      const auto around = neighbors(v);
      if (collapse(v, around, square(short_edge * lengths[v])))
        todo.insert(around.begin(), around.end());
    }
  }

  // Moves a vertex to its nearest possible neighbor, up to a distance.
  bool collapse(std::size_t v, const std::vector<std::size_t>& around, double most) {
    std::vector<std::pair<double, std::size_t>> lengths;
    for (std::size_t w : around)
      lengths.emplace_back(squared_distance(point(v), point(w)), w);
    std::sort(lengths.begin(), lengths.end());
    for (const auto& [squared_length, w] : lengths) {
      if (squared_length > most)
        break;
      if (can_collapse(v, w, around)) {
        do_collapse(v, w);
        return true;
      }
    }
    return false;
  }

  // Returns whether only the triangles at an edge connect its ends.
  bool has_simple_link(std::size_t v, std::size_t w, const std::vector<std::size_t>& around) const {
    const auto around_w = neighbors(w);
    std::vector<std::size_t> common, opposite;
    std::set_intersection(around.begin(), around.end(), around_w.begin(), around_w.end(),
                          std::back_inserter(common));
    for (std::size_t t : triangles_at(v, w))
      for (std::size_t u : m_soup.triangles[t])
        if (u != v && u != w)
          opposite.push_back(u);
    std::sort(opposite.begin(), opposite.end());
    opposite.erase(std::unique(opposite.begin(), opposite.end()), opposite.end());
    if (common != opposite)
      return false;
    // No triangle of v may become a triangle of w.
    for (std::size_t t : m_triangles_at[v]) {
      Triangle_indices moved = m_soup.triangles[t];
      if (has(moved, w))
        continue;
      std::replace(moved.begin(), moved.end(), v, w);
      for (std::size_t other : m_triangles_at[w])
        if (std::is_permutation(moved.begin(), moved.end(), m_soup.triangles[other].begin()))
          return false;
    }
    return true;
  }

  // Returns whether lines through a vertex stay where they are if it moves to a neighbor.
  bool keeps_lines(std::size_t v, std::size_t w, const std::vector<std::size_t>& around) const {
    std::vector<std::size_t> ends;
    for (std::size_t u : around)
      if (is_line(v, u))
        ends.push_back(u);
    if (ends.empty())
      return true;
    if (ends.size() != 2 || (w != ends[0] && w != ends[1]))
      return false;
    const std::size_t u = w == ends[0] ? ends[1] : ends[0];
    return squared_distance(point(v), Kernel::Segment_3(point(u), point(w))) <= square(m_distance);
  }

  // Returns whether a vertex can move to a neighbor: triangles stay in their planes and are not
  // inverted, the least height of triangles does not become much smaller, and lines stay where they
  // are.
  bool can_collapse(std::size_t v, std::size_t w, const std::vector<std::size_t>& around) const {
    static constexpr double none = std::numeric_limits<double>::infinity();
    double least_before = none, least_after = none;
    for (std::size_t t : m_triangles_at[v]) {
      const Triangle_indices& corners = m_soup.triangles[t];
      const Vector before = normal(corners);
      const double height = before * (point(w) - point(v));
      if (height * height > square(m_distance) * before.squared_length())
        return false;
      least_before = (std::min)(least_before, height_of(corners));
      if (has(corners, w))
        continue;
      Triangle_indices moved = corners;
      std::replace(moved.begin(), moved.end(), v, w);
      if (!(normal(moved) * before > 0))
        return false;
      least_after = (std::min)(least_after, height_of(moved));
    }
    return least_after > least_height * least_before && keeps_lines(v, w, around) &&
           has_simple_link(v, w, around);
  }

  // Returns the least height of a triangle.
  double height_of(const Triangle_indices& t) const {
    double longest = 0;
    for (int i = 0; i < 3; ++i)
      longest = (std::max)(longest, squared_distance(point(t[i]), point(t[(i + 1) % 3])));
    return std::sqrt(normal(t).squared_length() / longest);
  }

  void do_collapse(std::size_t v, std::size_t w) {
    for (std::size_t t : m_triangles_at[v]) {
      Triangle_indices& corners = m_soup.triangles[t];
      if (has(corners, w)) {
        m_is_alive[t] = 0;
        for (std::size_t u : corners)
          if (u != v)
            remove(u, t);
      } else {
        std::replace(corners.begin(), corners.end(), v, w);
        m_triangles_at[w].push_back(t);
      }
    }
    m_triangles_at[v].clear();
  }

  void remove(std::size_t v, std::size_t t) {
    auto& triangles = m_triangles_at[v];
    triangles.erase(std::find(triangles.begin(), triangles.end(), t));
  }

  void flip_edges() {
    std::set<Edge> todo;
    for (std::size_t t = 0; t < m_soup.triangles.size(); ++t)
      if (m_is_alive[t])
        push_edges(t, todo);
    // Each flip brings the walls nearer to Delaunay triangulations, up to rounding.
    for (std::size_t most = most_flips * todo.size(); !todo.empty() && most > 0; --most) {
      Progress_scope::check();
      const auto [v, w] = *todo.begin();
      todo.erase(todo.begin());
      flip(v, w, todo);
    }
  }

  void push_edges(std::size_t t, std::set<Edge>& todo) const {
    const Triangle_indices& c = m_soup.triangles[t];
    for (int i = 0; i < 3; ++i)
      todo.insert({(std::min)(c[i], c[(i + 1) % 3]), (std::max)(c[i], c[(i + 1) % 3])});
  }

  static std::size_t opposite(const Triangle_indices& t, std::size_t v, std::size_t w) {
    return *std::find_if(t.begin(), t.end(), [&](std::size_t u) { return u != v && u != w; });
  }

  void flip(std::size_t v, std::size_t w, std::set<Edge>& todo) {
    const auto triangles = triangles_at(v, w);
    if (triangles.size() != 2 || is_line(v, w))
      return;
    Triangle_indices &s = m_soup.triangles[triangles[0]], &t = m_soup.triangles[triangles[1]];
    const std::size_t a = opposite(s, v, w), b = opposite(t, v, w);
    Triangle_indices first = s, second = t;
    std::replace(first.begin(), first.end(), v, b);
    std::replace(second.begin(), second.end(), w, a);
    if (!is_flat(v, w, a, b) || !triangles_at(a, b).empty() ||
        !(angle(a, v, w) + angle(b, v, w) > 1 + flip_gain) || !(normal(first) * normal(s) > 0) ||
        !(normal(second) * normal(t) > 0))
      return;
    s = first;
    t = second;
    remove(v, triangles[0]);
    remove(w, triangles[1]);
    m_triangles_at[b].push_back(triangles[0]);
    m_triangles_at[a].push_back(triangles[1]);
    push_edges(triangles[0], todo);
    push_edges(triangles[1], todo);
  }

  // Returns the angle of a triangle at its first corner, in half turns.
  double angle(std::size_t a, std::size_t v, std::size_t w) const {
    const Vector x = point(v) - point(a), y = point(w) - point(a);
    return std::atan2(std::sqrt(cross_product(x, y).squared_length()), x * y) / CGAL_PI;
  }

  // Returns whether the triangles at an edge are in one plane.
  bool is_flat(std::size_t v, std::size_t w, std::size_t a, std::size_t b) const {
    const double six_volumes =
        determinant(point(w) - point(v), point(a) - point(v), point(b) - point(v));
    double largest = 0;
    for (const Triangle_indices& t : {Triangle_indices{v, w, a}, Triangle_indices{v, w, b}})
      largest = (std::max)(largest, normal(t).squared_length());
    return six_volumes * six_volumes <= square(m_distance) * largest;
  }

  Walls_3 m_soup;
  double m_distance;
  std::vector<std::vector<std::size_t>> m_triangles_at;
  std::vector<char> m_is_alive;
};

// Returns walls without needles where they are flat, or the same walls if triangles would
// intersect.
inline Walls_3 simplify_flat_parts(const Walls_3& walls, double distance) {
  Flat_simplifier_3 simplifier(walls, distance);
  simplifier.run();
  Walls_3 result = simplifier.result();
  return crossing_triangles(merge_points(result)).empty() ? result : walls;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_ARRANGEMENT_FLAT_SIMPLIFIER_3_H
