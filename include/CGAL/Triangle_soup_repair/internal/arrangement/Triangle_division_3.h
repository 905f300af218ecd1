// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_ARRANGEMENT_TRIANGLE_DIVISION_3_H
#define CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_ARRANGEMENT_TRIANGLE_DIVISION_3_H

#include <CGAL/Triangle_soup_repair/internal/soups/Triangle_soup_3.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/enum.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Divides a triangle at vertices on its edges and inside it, and along segments between them. The
// vertices may lie slightly off the triangle. Triangles that overlap in nearly the same plane are
// divided alike where they have the same vertices and segments.
//
// Segments should not cross. If they do, a vertex is added to the points where they cross.
class Triangle_division_3
{
public:
  using Polygon = std::vector<std::size_t>;

  // \param points all points; points where segments cross are appended
  // \param corners corners of the triangle
  // \param polygon distinct vertices along the edges, in the order of the corners
  Triangle_division_3(std::vector<Coordinates_3>& points, const Triangle_indices& corners,
                      const Polygon& polygon)
      : m_points(points), m_corners(corners) {
    choose_axis();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      insert(polygon[i], polygon[(i + 1) % polygon.size()]);
      m_places.emplace(polygon[i], i);
    }
  }

  void insert(std::size_t v) { handle(v); }
  void insert(std::size_t v, std::size_t w) {
    const auto a = handle(v), b = handle(w);
    if (a != b)
      m_triangulation.insert_constraint(a, b);
  }

  // Returns the triangles, oriented like the original one.
  std::vector<Triangle_indices> triangles() {
    number_crossings();
    flip_to_least_vertices();
    std::vector<Triangle_indices> result;
    for (const auto f : m_triangulation.finite_face_handles()) {
      Triangle_indices t = {index(f, 0), index(f, 1), index(f, 2)};
      if (!m_is_counterclockwise)
        std::swap(t[1], t[2]);
      if (is_inside(t))
        result.push_back(t);
    }
    return result;
  }

private:
  using Kernel = Predicates_kernel;

  static constexpr std::size_t unknown = std::size_t(-1);

  struct Index
  {
    std::size_t value = unknown; // a vertex where segments cross has no index at first
  };

  using Vertex = Triangulation_vertex_base_with_info_2<Index, Kernel>;
  using Face = Constrained_triangulation_face_base_2<Kernel>;
  using Triangulation =
      Constrained_Delaunay_triangulation_2<Kernel, Triangulation_data_structure_2<Vertex, Face>,
                                           Exact_predicates_tag>;
  using Vertex_handle = typename Triangulation::Vertex_handle;
  using Face_handle = typename Triangulation::Face_handle;

  // Chooses the axis along which the triangle is projected. Different weights make it unlikely that
  // rounding decides between axes: overlapping triangles should have the same axis.
  void choose_axis() {
    static constexpr std::array<double, 3> weights = {1, 1.1, 1.21};
    const auto a = exact_point(m_points[m_corners[0]]), b = exact_point(m_points[m_corners[1]]),
               c = exact_point(m_points[m_corners[2]]);
    const auto normal = cross_product(b - a, c - a);
    double largest = -1;
    for (int axis = 0; axis < 3; ++axis)
      if (const double size = weights[axis] * std::abs(normal[axis]); size > largest) {
        largest = size;
        m_axis = axis;
      }
    m_is_counterclockwise = normal[m_axis] > 0;
  }

  Kernel::Point_2 project(std::size_t v) const {
    return {m_points[v][(m_axis + 1) % 3], m_points[v][(m_axis + 2) % 3]};
  }

  static std::size_t index(Face_handle f, int i) { return f->vertex(i)->info().value; }

  Vertex_handle handle(std::size_t v) {
    const auto [place, is_new] = m_handles.emplace(v, Vertex_handle());
    if (is_new) {
      place->second = m_triangulation.insert(project(v));
      place->second->info().value = v;
    }
    return place->second;
  }

  // Adds the vertices that crossings of segments made to the points.
  void number_crossings() {
    const auto plane =
        Kernel::Plane_3(exact_point(m_points[m_corners[0]]), exact_point(m_points[m_corners[1]]),
                        exact_point(m_points[m_corners[2]]));
    const std::array<double, 3> normal = {plane.a(), plane.b(), plane.c()};
    for (const auto v : m_triangulation.finite_vertex_handles()) {
      if (v->info().value != unknown)
        continue;
      const int i = (m_axis + 1) % 3, j = (m_axis + 2) % 3;
      Coordinates_3 p;
      p[i] = v->point().x();
      p[j] = v->point().y();
      p[m_axis] = -(normal[i] * p[i] + normal[j] * p[j] + plane.d()) / normal[m_axis];
      v->info().value = m_points.size();
      m_points.push_back(p);
    }
  }

  // Among the triangulations of cocircular vertices, which are all Delaunay, one is chosen that
  // does not depend on the order of insertion: the fans around the least vertices.
  void flip_to_least_vertices() {
    for (bool is_changed = true; is_changed;) {
      is_changed = false;
      for (const auto f : m_triangulation.finite_face_handles())
        for (int i = 0; i < 3; ++i)
          if (should_flip(f, i)) {
            m_triangulation.tds().flip(f, i);
            is_changed = true;
          }
    }
  }

  bool should_flip(Face_handle f, int i) const {
    const Face_handle g = f->neighbor(i);
    if (m_triangulation.is_infinite(g) || f->is_constrained(i))
      return false;
    const int j = g->index(f);
    if (!((std::min)(index(f, i), index(g, j)) <
          (std::min)(index(f, Triangulation::ccw(i)), index(f, Triangulation::cw(i)))))
      return false;
    const auto &a = f->vertex(i)->point(), &b = f->vertex(Triangulation::ccw(i))->point(),
               &c = f->vertex(Triangulation::cw(i))->point(), &d = g->vertex(j)->point();
    return side_of_oriented_circle(a, b, c, d) == ON_ORIENTED_BOUNDARY &&
           orientation(a, b, d) == LEFT_TURN && orientation(a, d, c) == LEFT_TURN;
  }

  // Returns whether a triangle of the triangulation is inside the polygon. Triangles
  // outside have three corners on the polygon, in the reverse order.
  bool is_inside(const Triangle_indices& t) const {
    std::array<std::size_t, 3> places;
    for (int i = 0; i < 3; ++i) {
      const auto found = m_places.find(t[i]);
      if (found == m_places.end())
        return true;
      places[i] = found->second;
    }
    std::rotate(places.begin(), std::min_element(places.begin(), places.end()), places.end());
    return places[1] < places[2];
  }

  std::vector<Coordinates_3>& m_points;
  Triangle_indices m_corners;
  std::map<std::size_t, std::size_t> m_places; // of vertices along the edges
  int m_axis = 0;
  bool m_is_counterclockwise = true; // orientation of the projection
  Triangulation m_triangulation;
  std::map<std::size_t, Vertex_handle> m_handles;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_ARRANGEMENT_TRIANGLE_DIVISION_3_H
