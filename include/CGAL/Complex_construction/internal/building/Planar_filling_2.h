// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_PLANAR_FILLING_2_H
#define CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_PLANAR_FILLING_2_H

#include <CGAL/Complex_construction/internal/building/Curve_soup_2.h>
#include <CGAL/Complex_construction/internal/building/label_cells.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/internal/cgal/cgal_compat.h>
#include <CGAL/Triangle_soup_repair/Invalid_surface_error.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Bbox_2.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <memory>
#include <set>

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

// Throws `Invalid_surface_error` if segments cross or overlap. Takes time O(n log n) if few
// bounding boxes of segments overlap, and otherwise up to O(n^2).
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

// Points that a mesh needs in addition to the points of curves. Their spacing near a curve is given
// in lengths of its segments, and it grows with the distance from the curves. Points on the
// boundary of the box follow the same spacing if curves end there.
class Graded_points_2
{
public:
  using Point = Planar_kernel::Point_2;

  Graded_points_2(const Curve_soup_2& soup, const Bbox_2& box, double spacing_per_segment)
      : m_box(box), m_densest(spacing_per_segment),
        m_gradation((std::min)(steepest, spacing_per_segment / 2)), m_clearance(m_gradation) {
    const auto in_space = [&](std::size_t v) {
      return Planar_kernel::Point_3(soup.points[v].x(), soup.points[v].y(), 0);
    };
    for (const Wall<2>& w : soup.walls)
      m_segments.emplace_back(in_space(w.vertices[0]), in_space(w.vertices[1]));
    m_tree.insert(m_segments.begin(), m_segments.end());
    if (!m_segments.empty())
      m_tree.accelerate_distance_queries();
    m_reaches_box = std::any_of(soup.points.begin(), soup.points.end(), [&](const Point& p) {
      return p.x() == box.xmin() || p.x() == box.xmax() || p.y() == box.ymin() ||
             p.y() == box.ymax();
    });
    const double width = box.xmax() - box.xmin(), height = box.ymax() - box.ymin();
    const double side =
        (std::min)((std::max)(width, height) / least_parts, (std::min)(width, height));
    m_columns = number_of_parts(width / side);
    m_rows = number_of_parts(height / side);
    for (int i = 0; i < m_columns; ++i)
      for (int j = 0; j < m_rows; ++j)
        divide(x(i), y(j), x(i + 1), y(j + 1), 0);
    for (int i = 0; i <= m_columns; ++i)
      for (int j = 0; j <= m_rows; ++j)
        if (i == 0 || i == m_columns || j == 0 || j == m_rows)
          add_border(x(i), y(j));
  }

  const std::vector<Point>& points() const { return m_points; }

private:
  using Segments = std::vector<Planar_kernel::Segment_3>;
  using Tree = AABB_tree<Segment_tree_traits_3<Planar_kernel, Segments::const_iterator>>;

  static constexpr int least_parts = 8; // minimum number of parts of the longer side of the box
  // maximum number of parts of a side, before refinement near curves
  static constexpr int most_parts = 1000;
  // maximum number of halvings, since coordinates are of type `double`
  static constexpr int most_divisions = 40;
  static constexpr double steepest = 1; // maximum gradation

  static int number_of_parts(double n) {
    return int(std::lround((std::max)(1., (std::min)(double(most_parts), n))));
  }

  double x(int i) const { return at(m_box.xmin(), m_box.xmax(), i, m_columns); }
  double y(int j) const { return at(m_box.ymin(), m_box.ymax(), j, m_rows); }
  static double at(double low, double high, int i, int n) {
    return i == n ? high : low + (high - low) * (double(i) / n);
  }

  struct Nearest
  {
    double distance, length; // of the nearest segment
  };

  Nearest nearest(double x, double y) const {
    if (m_segments.empty())
      return {std::numeric_limits<double>::infinity(), 0};
    const Planar_kernel::Point_3 p(x, y, 0);
    const auto found = m_tree.closest_point_and_primitive(p);
    return {std::sqrt(CGAL::squared_distance(p, found.first)),
            std::sqrt(found.second->squared_length())};
  }

  // Adds a point on the boundary of the box. If curves end on the boundary, points too close to a
  // curve are omitted, except for the corners of the box.
  void add_border(double x, double y) {
    const bool is_corner =
        (x == m_box.xmin() || x == m_box.xmax()) && (y == m_box.ymin() || y == m_box.ymax());
    const Nearest nearby = m_reaches_box && !is_corner ? nearest(x, y) : Nearest{1, 0};
    if (nearby.distance > m_clearance * nearby.length)
      m_points.emplace_back(x, y);
  }

  // Adds the corners of a rectangle that lie on the boundary of the box.
  void add_border(double x0, double y0, double x1, double y1) {
    for (double x : {x0, x1})
      for (double y : {y0, y1})
        if (x == m_box.xmin() || x == m_box.xmax() || y == m_box.ymin() || y == m_box.ymax())
          add_border(x, y);
  }

  // Divides a rectangle into four quarters until it is small compared with its distance from the
  // curves; then adds its center.
  void divide(double x0, double y0, double x1, double y1, int divisions) {
    Progress_scope::check();
    const double x = (x0 + x1) / 2, y = (y0 + y1) / 2, side = (std::max)(x1 - x0, y1 - y0);
    const auto [distance, length] = nearest(x, y);
    if (side > (std::max)(m_densest * length, m_gradation * distance) &&
        divisions < most_divisions) {
      divide(x0, y0, x, y, divisions + 1);
      divide(x, y0, x1, y, divisions + 1);
      divide(x0, y, x, y1, divisions + 1);
      divide(x, y, x1, y1, divisions + 1);
      return;
    }
    if (distance > m_clearance * length)
      m_points.emplace_back(x, y);
    if (m_reaches_box)
      add_border(x0, y0, x1, y1);
  }

  Bbox_2 m_box;
  double m_densest;   // spacing at a curve, in lengths of the nearest segment
  double m_gradation; // maximum ratio of the spacing to the distance from the curves
  double m_clearance; // minimum distance of a point from a curve, in lengths of the nearest segment
  int m_columns, m_rows;
  bool m_reaches_box;
  Segments m_segments; // in the plane z = 0, because the AABB tree is three-dimensional
  Tree m_tree;
  std::vector<Point> m_points;
};

// Triangles that fill a box. The segments of the curves are edges of the triangles. The spacing of
// additional points follows the lengths of the nearest segments.
struct Planar_filling_2
{
  using Point = Planar_kernel::Point_2;

  struct Place
  {
    // a triangle that contains the point, on its boundary or inside
    std::optional<std::size_t> triangle;
    bool is_on_segment;
  };

  std::vector<Point> points; // the points of the soup, then additional points
  std::vector<std::array<std::size_t, 3>> triangles;
  std::function<Place(const Point&)> locate; // returns no triangle for a point outside the box
};

template <class Kernel>
using Planar_triangulation_2 = Constrained_Delaunay_triangulation_2<
    Kernel,
    Triangulation_data_structure_2<
        Triangulation_vertex_base_with_info_2<std::size_t, Kernel>,
        Triangulation_face_base_with_info_2<std::size_t, Kernel,
                                            Constrained_triangulation_face_base_2<Kernel>>>,
    No_constraint_intersection_tag>;

// Inserts points in the order of a space-filling curve. Returns their vertices.
template <class Kernel>
std::vector<typename Planar_triangulation_2<Kernel>::Vertex_handle>
insert_points(const std::vector<typename Kernel::Point_2>& points,
              Planar_triangulation_2<Kernel>& triangulation) {
  using Points = typename Pointer_property_map<typename Kernel::Point_2>::const_type;
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  spatial_sort(order.begin(), order.end(),
               Spatial_sort_traits_adapter_2<Kernel, Points>(make_property_map(points.data())));
  std::vector<typename Planar_triangulation_2<Kernel>::Vertex_handle> vertices(points.size());
  typename Planar_triangulation_2<Kernel>::Face_handle nearby;
  for (std::size_t i : order) {
    Progress_scope::check();
    vertices[i] = triangulation.insert(points[i], nearby);
    nearby = vertices[i]->face();
  }
  return vertices;
}

// An error: segments of curves cross or overlap.
struct Crossing_segments : Error
{
  Crossing_segments() : Error("segments cross or overlap: they may meet only in common ends") {}
};

// Inserts the segments of curves, each once, although several curves may contain it. Throws
// `Crossing_segments` if a segment crosses another one or passes through a point, or a curve
// contains a segment twice. Takes little more time if all bounding boxes of segments overlap.
template <class Kernel>
std::vector<typename Planar_triangulation_2<Kernel>::Vertex_handle>
insert_curves(const Curve_soup_2& soup, Planar_triangulation_2<Kernel>& triangulation) {
  const auto handles = insert_points(soup.points, triangulation);
  std::set<std::array<std::size_t, 2>> segments;
  std::set<std::pair<std::array<std::size_t, 2>, std::size_t>> segments_of_curves;
  for (const auto& wall : soup.walls) {
    Progress_scope::check();
    if (!segments_of_curves.emplace(wall.vertices, wall.surface).second)
      throw Crossing_segments();
    if (!segments.insert(wall.vertices).second)
      continue;
    const auto v = handles[wall.vertices[0]], w = handles[wall.vertices[1]];
    try {
      triangulation.insert_constraint(v, w);
    } catch (
        const typename Planar_triangulation_2<Kernel>::Intersection_of_constraints_exception&) {
      throw Crossing_segments();
    }
    if (!triangulation.is_edge(v, w))
      throw Crossing_segments();
  }
  return handles;
}

// Triangulates a box like `fill_planar_box()`. Curves may end on the box. There may be no curve.
// Throws `Crossing_segments` if segments cross or overlap.
template <class Kernel = Planar_kernel>
Planar_filling_2 fill_box_between(const Curve_soup_2& soup, const Bbox_2& box,
                                  double spacing_per_segment) {
  using Point = typename Kernel::Point_2;
  using Triangulation = Planar_triangulation_2<Kernel>;
  static constexpr std::size_t none = std::size_t(-1);

  const Progress_phase phase("filling the box with triangles");
  const auto triangulation = std::make_shared<Triangulation>();
  const auto handles = insert_curves<Kernel>(soup, *triangulation);
  insert_points(Graded_points_2(soup, box, spacing_per_segment).points(), *triangulation);

  Planar_filling_2 filling;
  for (auto v : triangulation->finite_vertex_handles())
    v->info() = none;
  const auto number = [&](typename Triangulation::Vertex_handle v) {
    if (v->info() == none) {
      v->info() = filling.points.size();
      filling.points.push_back(v->point());
    }
  };
  for (auto v : handles)
    number(v);
  for (auto v : triangulation->finite_vertex_handles())
    number(v);
  for (auto f : triangulation->finite_face_handles()) {
    f->info() = filling.triangles.size();
    filling.triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  }
  filling.locate = [triangulation](const Point& p) -> Planar_filling_2::Place {
    typename Triangulation::Locate_type type;
    int i;
    const auto f = triangulation->locate(p, type, i);
    if (f == nullptr || triangulation->is_infinite(f))
      return {{}, false};
    return {f->info(), type == Triangulation::VERTEX
                           ? triangulation->are_there_incident_constraints(f->vertex(i))
                           : type == Triangulation::EDGE && f->is_constrained(i)};
  };
  return filling;
}

// Triangulates a box with curves in it. Throws `Invalid_surface_error` if segments cross or
// overlap.
template <class Kernel = Planar_kernel>
Planar_filling_2 fill_planar_box(const Curve_soup_2& soup, const Bbox_2& box,
                                 double spacing_per_segment) {
  try {
    return fill_box_between<Kernel>(soup, box, spacing_per_segment);
  } catch (const Crossing_segments&) {
    check_crossings<Kernel>(soup);
    throw;
  }
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_PLANAR_FILLING_2_H
