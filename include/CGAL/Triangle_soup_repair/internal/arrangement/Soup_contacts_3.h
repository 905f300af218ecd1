// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_ARRANGEMENT_SOUP_CONTACTS_3_H
#define CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_ARRANGEMENT_SOUP_CONTACTS_3_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Triangle_soup_3.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

inline Bbox_3 enlarged(const Bbox_3& box, double r) {
  return {box.xmin() - r, box.ymin() - r, box.zmin() - r,
          box.xmax() + r, box.ymax() + r, box.zmax() + r};
}

// The places where features of a soup are nearer to each other than a distance, though they have no
// common vertex: vertices on edges, vertices in triangles, and edges that cross. A vertex near an
// edge is not counted as near the triangles at the edge, nor do edges cross near their ends.
//
// Takes time O(n log n), plus the number of features whose boxes meet.
// The distance is smaller for edges, and still smaller for triangles, so that two vertices near a
// triangle do not have the same projection.
// \pre no two points are nearer than the distance
class Soup_contacts_3
{
public:
  // A vertex on an edge.
  struct Place
  {
    double parameter; // 0 at the end with the smaller index, 1 at the other
    std::size_t vertex;

    bool operator<(const Place& p) const {
      return parameter != p.parameter ? parameter < p.parameter : vertex < p.vertex;
    }
  };

  struct Edge
  {
    std::array<std::size_t, 2> ends; // in increasing order
    std::vector<Place> places;       // sorted
  };

  Soup_contacts_3(const Triangle_soup_3& soup, double distance)
      : m_soup(soup), m_distance(distance), m_edges_of(soup.triangles.size()),
        m_inside(soup.triangles.size()) {
    collect_edges();
    const Boxes vertices = boxes_of_vertices(), edges = boxes_of_edges();
    find_vertices_on_edges(vertices, edges);
    find_crossings(edges);
    find_vertices_in_triangles(vertices);
    for (Edge& e : m_edges) {
      std::sort(e.places.begin(), e.places.end());
      e.places.erase(
          std::unique(e.places.begin(), e.places.end(),
                      [](const Place& p, const Place& q) { return p.vertex == q.vertex; }),
          e.places.end());
    }
    for (auto& vertices_inside : m_inside)
      std::sort(vertices_inside.begin(), vertices_inside.end());
  }

  std::size_t size() const { return m_number; }

  // The points where edges cross; their indices follow those of the points of the soup.
  const std::vector<Coordinates_3>& new_points() const { return m_new_points; }

  const std::vector<Edge>& edges() const { return m_edges; }

  // Returns the edges of a triangle; edge i is opposite to corner i.
  const std::array<std::size_t, 3>& edges_of(std::size_t triangle) const {
    return m_edges_of[triangle];
  }

  // Returns the vertices in the interior of a triangle, sorted.
  const std::vector<std::size_t>& inside(std::size_t triangle) const { return m_inside[triangle]; }

private:
  static constexpr double of_edges = .7, of_triangles = .4; // of the distance

  using Box = Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;
  using Boxes = std::vector<Box>;
  using Point = Predicates_kernel::Point_3;
  using Vector = Predicates_kernel::Vector_3;

  Point point(std::size_t v) const { return exact_point(m_soup.points[v]); }

  bool is_same_vertex(const Point& p, const Point& q) const {
    return squared_distance(p, q) <= square(m_distance);
  }
  bool is_on_edge(const Point& p, const Point& q) const {
    return squared_distance(p, q) <= square(of_edges * m_distance);
  }

  void collect_edges() {
    const auto sides = sorted_sides(m_soup.triangles);
    for (auto side = sides.begin(); side != sides.end(); ++side) {
      if (m_edges.empty() || m_edges.back().ends != side->vertices)
        m_edges.push_back({side->vertices, {}});
      const Triangle_indices& t = m_soup.triangles[side->triangle];
      const auto corner = std::find(t.begin(), t.end(), side->opposite_vertex) - t.begin();
      m_edges_of[side->triangle][corner] = m_edges.size() - 1;
    }
  }

  Boxes boxes_of_vertices() const {
    Boxes result;
    for (std::size_t v = 0; v < m_soup.points.size(); ++v)
      result.emplace_back(enlarged(point(v).bbox(), m_distance), v);
    return result;
  }

  Boxes boxes_of_edges() const {
    Boxes result;
    for (std::size_t e = 0; e < m_edges.size(); ++e)
      result.emplace_back(enlarged(segment(m_edges[e]).bbox(), m_distance / 2), e);
    return result;
  }

  Predicates_kernel::Segment_3 segment(const Edge& e) const {
    return {point(e.ends[0]), point(e.ends[1])};
  }

  // Returns the parameter of the point of a line that is nearest to a point.
  double parameter(std::size_t v, const Edge& e) const {
    const Vector along = segment(e).to_vector();
    return (point(v) - point(e.ends[0])) * along / along.squared_length();
  }

  Point point_on(const Edge& e, double t) const {
    return point(e.ends[0]) + t * segment(e).to_vector();
  }

  // Returns whether a vertex that is no end of an edge is near it.
  bool is_on(std::size_t v, const Edge& e) const {
    const double t = parameter(v, e);
    return t > 0 && t < 1 && is_on_edge(point(v), point_on(e, t));
  }

  static bool is_end(std::size_t v, const Edge& e) { return v == e.ends[0] || v == e.ends[1]; }

  void find_vertices_on_edges(Boxes vertices, Boxes edges) {
    box_intersection_d(vertices.begin(), vertices.end(), edges.begin(), edges.end(),
                       [&](const Box& v, const Box& e) {
                         Progress_scope::check();
                         Edge& edge = m_edges[e.info()];
                         if (!is_end(v.info(), edge) && is_on(v.info(), edge)) {
                           edge.places.push_back({parameter(v.info(), edge), v.info()});
                           ++m_number;
                         }
                       });
  }

  void find_crossings(Boxes boxes) {
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    box_self_intersection_d(
        boxes.begin(), boxes.end(),
        [&](const Box& a, const Box& b) {
          Progress_scope::check();
          const Edge &e = m_edges[a.info()], &f = m_edges[b.info()];
          if (!is_end(e.ends[0], f) && !is_end(e.ends[1], f) && do_cross(e, f))
            pairs.push_back(std::minmax(a.info(), b.info()));
        },
        undivided_boxes);
    std::sort(pairs.begin(), pairs.end());
    for (const auto& [e, f] : pairs)
      add_crossing(m_edges[e], m_edges[f]);
  }

  // The parameters of the points where two lines are nearest to each other.
  std::array<double, 2> nearest(const Edge& e, const Edge& f) const {
    const Vector u = segment(e).to_vector(), v = segment(f).to_vector(),
                 w = point(f.ends[0]) - point(e.ends[0]);
    const double uu = u * u, uv = u * v, vv = v * v, uw = u * w, vw = v * w;
    const double denominator = uu * vv - uv * uv;
    return {(uw * vv - vw * uv) / denominator, (uw * uv - vw * uu) / denominator};
  }

  bool do_cross(const Edge& e, const Edge& f) const {
    const auto [s, t] = nearest(e, f); // not a number if the edges are parallel
    if (!(s > 0 && s < 1 && t > 0 && t < 1) || !is_on_edge(point_on(e, s), point_on(f, t)))
      return false;
    for (int i = 0; i < 2; ++i)
      if (is_on(e.ends[i], f) || is_on(f.ends[i], e))
        return false;
    return true;
  }

  // Adds the end of one edge to the other edge if it is near the crossing, otherwise a new vertex
  // to both.
  void add_crossing(Edge& e, Edge& f) {
    const auto [s, t] = nearest(e, f);
    const Point crossing = midpoint(point_on(e, s), point_on(f, t));
    ++m_number;
    for (int i = 0; i < 2; ++i) {
      if (is_same_vertex(point(e.ends[i]), crossing)) {
        f.places.push_back({t, e.ends[i]});
        return;
      }
      if (is_same_vertex(point(f.ends[i]), crossing)) {
        e.places.push_back({s, f.ends[i]});
        return;
      }
    }
    const std::size_t v = m_soup.points.size() + m_new_points.size();
    m_new_points.push_back(coordinates(crossing));
    e.places.push_back({s, v});
    f.places.push_back({t, v});
  }

  void find_vertices_in_triangles(Boxes vertices) {
    Boxes triangles;
    for (std::size_t t = 0; t < m_soup.triangles.size(); ++t)
      triangles.emplace_back(exact_triangle(m_soup, t).bbox(), t);
    box_intersection_d(vertices.begin(), vertices.end(), triangles.begin(), triangles.end(),
                       [&](const Box& v, const Box& t) {
                         Progress_scope::check();
                         if (is_inside(v.info(), t.info())) {
                           m_inside[t.info()].push_back(v.info());
                           ++m_number;
                         }
                       });
  }

  // Returns whether a vertex is near a triangle, but not near its edges.
  bool is_inside(std::size_t v, std::size_t t) const {
    const Triangle_indices& corners = m_soup.triangles[t];
    if (std::find(corners.begin(), corners.end(), v) != corners.end())
      return false;
    const Vector a = point(corners[1]) - point(corners[0]),
                 b = point(corners[2]) - point(corners[0]), p = point(v) - point(corners[0]),
                 normal = cross_product(a, b);
    const double size = normal.squared_length(), height = p * normal;
    if (!(height * height <= square(of_triangles * m_distance) * size))
      return false;
    const double s = cross_product(p, b) * normal / size, r = cross_product(a, p) * normal / size;
    if (!(s > 0 && r > 0 && s + r < 1))
      return false;
    for (std::size_t e : m_edges_of[t])
      if (is_on(v, m_edges[e]))
        return false;
    return true;
  }

  const Triangle_soup_3& m_soup;
  double m_distance;
  std::vector<Edge> m_edges;
  std::vector<std::array<std::size_t, 3>> m_edges_of;
  std::vector<std::vector<std::size_t>> m_inside;
  std::vector<Coordinates_3> m_new_points;
  std::size_t m_number = 0;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_ARRANGEMENT_SOUP_CONTACTS_3_H
