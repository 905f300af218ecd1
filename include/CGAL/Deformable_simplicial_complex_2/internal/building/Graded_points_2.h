// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_BUILDING_GRADED_POINTS_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_BUILDING_GRADED_POINTS_2_H

#include <CGAL/Bbox_2.h>
#include <CGAL/Deformable_simplicial_complex_2/internal/building/Curve_soup_2.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_2.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Points of the mesh off the curves: near these as dense as they are, and sparser away from them.
class Graded_points_2
{
public:
  using Point = Planar_kernel::Point_2;

  Graded_points_2(const Curve_soup_2& soup, const Bbox_2& box) : m_box(box) {
    std::vector<double> lengths(soup.points.size(), 0);
    std::vector<std::size_t> degrees(soup.points.size(), 0);
    for (const Wall<2>& w : soup.walls) {
      const double length =
          std::sqrt(CGAL::squared_distance(soup.points[w.vertices[0]], soup.points[w.vertices[1]]));
      for (std::size_t v : w.vertices) {
        lengths[v] += length;
        ++degrees[v];
      }
      // A long segment is known by points along it.
      const auto &p = soup.points[w.vertices[0]], &q = soup.points[w.vertices[1]];
      static constexpr int parts = 4;
      for (int i = 0; i < parts; ++i)
        m_samples.emplace_back(p + (i / double(parts)) * (q - p), length);
    }
    m_tree.insert(m_samples.begin(), m_samples.end());
    m_tree.build();
    const double side = (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
    m_columns = (std::max)(1, int(std::lround(least_parts * (box.xmax() - box.xmin()) / side)));
    m_rows = (std::max)(1, int(std::lround(least_parts * (box.ymax() - box.ymin()) / side)));
    for (int i = 0; i < m_columns; ++i)
      for (int j = 0; j < m_rows; ++j)
        divide(x(i), y(j), x(i + 1), y(j + 1), 0);
    for (int i = 0; i <= m_columns; ++i)
      for (int j = 0; j <= m_rows; ++j)
        if (i == 0 || i == m_columns || j == 0 || j == m_rows)
          m_points.emplace_back(x(i), y(j));
  }

  const std::vector<Point>& points() const { return m_points; }

private:
  using Sample = std::pair<Point, double>; // with the length of the segment it is on
  using Traits = Search_traits_adapter<Sample, First_of_pair_property_map<Sample>,
                                       Search_traits_2<Planar_kernel>>;
  using Search = Orthogonal_k_neighbor_search<Traits>;

  static constexpr int least_parts = 8;     // of the longer side of the box
  static constexpr int most_divisions = 40; // halvings, beyond which doubles do not tell
  static constexpr double clearance = .6;   // of a segment: nearer, a point would be in the way
  static constexpr double gradation = .6;   // of the distance from the curves, for the spacing

  double x(int i) const { return at(m_box.xmin(), m_box.xmax(), i, m_columns); }
  double y(int j) const { return at(m_box.ymin(), m_box.ymax(), j, m_rows); }
  static double at(double low, double high, int i, int n) {
    return i == n ? high : low + (high - low) * (double(i) / n);
  }

  // Four quarters, until a rectangle is small for its distance from the curves; its center then.
  void divide(double x0, double y0, double x1, double y1, int divisions) {
    const Point center((x0 + x1) / 2, (y0 + y1) / 2);
    Search search(m_tree, center, 1);
    const double distance = std::sqrt(search.begin()->second),
                 length = search.begin()->first.second, side = (std::max)(x1 - x0, y1 - y0);
    if (side > (std::max)(1.2 * length, gradation * distance) && divisions < most_divisions) {
      divide(x0, y0, center.x(), center.y(), divisions + 1);
      divide(center.x(), y0, x1, center.y(), divisions + 1);
      divide(x0, center.y(), center.x(), y1, divisions + 1);
      divide(center.x(), center.y(), x1, y1, divisions + 1);
    } else if (distance > clearance * length) {
      m_points.push_back(center);
    }
  }

  Bbox_2 m_box;
  int m_columns, m_rows;
  std::vector<Sample> m_samples;
  Kd_tree<Traits> m_tree;
  std::vector<Point> m_points;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_BUILDING_GRADED_POINTS_2_H
