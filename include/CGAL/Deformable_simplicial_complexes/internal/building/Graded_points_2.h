// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BUILDING_GRADED_POINTS_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BUILDING_GRADED_POINTS_2_H

#include <CGAL/AABB_tree.h>
#include <CGAL/Bbox_2.h>
#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>
#include <CGAL/Deformable_simplicial_complexes/cgal_compat.h>
#include <CGAL/Deformable_simplicial_complexes/internal/building/Curve_soup_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Points that a mesh needs in addition to the points of curves. Near a curve their spacing is about
// the length of its segments, and it grows with the distance from the curves. Points on the
// boundary of the box follow the same spacing if curves end there.
class Graded_points_2
{
public:
  using Point = Planar_kernel::Point_2;

  Graded_points_2(const Curve_soup_2& soup, const Bbox_2& box) : m_box(box) {
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
  static constexpr double densest = 1.2; // spacing at a curve, in lengths of the nearest segment
  // minimum distance of a point from a curve, in the same unit
  static constexpr double clearance = .6;
  // maximum ratio of the spacing to the distance from the curves
  static constexpr double gradation = .6;

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
    const Nearest near = m_reaches_box && !is_corner ? nearest(x, y) : Nearest{1, 0};
    if (near.distance > clearance * near.length)
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
    if (side > (std::max)(densest * length, gradation * distance) && divisions < most_divisions) {
      divide(x0, y0, x, y, divisions + 1);
      divide(x, y0, x1, y, divisions + 1);
      divide(x0, y, x, y1, divisions + 1);
      divide(x, y, x1, y1, divisions + 1);
      return;
    }
    if (distance > clearance * length)
      m_points.emplace_back(x, y);
    if (m_reaches_box)
      add_border(x0, y0, x1, y1);
  }

  Bbox_2 m_box;
  int m_columns, m_rows;
  bool m_reaches_box;
  Segments m_segments; // in the plane z = 0, because the AABB tree is three-dimensional
  Tree m_tree;
  std::vector<Point> m_points;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BUILDING_GRADED_POINTS_2_H
