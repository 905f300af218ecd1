#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_2_TEST_PLANAR_REGIONS_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_2_TEST_PLANAR_REGIONS_H

#include "test.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complex_2.h>

#include <CGAL/number_utils.h>

// Regions of the plane that polygons bound.
namespace planar_regions {

using Complex = CGAL::Deformable_simplicial_complex_2<>;
using Polygon = std::vector<Complex::Point_2>;

// Returns a polygon around a center. `radius` is a function of the angle.
inline Polygon around(const Complex::Point_2& center, std::size_t corners,
                      const std::function<double(double)>& radius) {
  Polygon result;
  for (std::size_t i = 0; i < corners; ++i) {
    const double a = 2 * CGAL_PI * double(i) / double(corners);
    result.emplace_back(center.x() + radius(a) * std::cos(a), center.y() + radius(a) * std::sin(a));
  }
  return result;
}

// Returns a circle around the origin with edges of about a given length.
inline Polygon circle(double radius, double edge) {
  return around({0, 0}, std::size_t(std::lround(2 * CGAL_PI * radius / edge)),
                [radius](double) { return radius; });
}

// Returns a polygon whose sides are divided into edges of about a given length.
inline Polygon divided(const Polygon& corners, double edge) {
  Polygon result;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto p = corners[i], q = corners[(i + 1) % corners.size()];
    const int parts = int(std::lround(std::sqrt(CGAL::squared_distance(p, q)) / edge));
    for (int k = 0; k < parts; ++k)
      result.push_back(p + (q - p) * (double(k) / parts));
  }
  return result;
}

// Returns the region inside a polygon, with label 1, and outside of a hole.
inline Complex region(const Polygon& polygon, const Polygon& hole, const CGAL::Bbox_2& box) {
  std::vector<DSC::Labeled_curve_2<Complex::Point_2>> curves;
  curves.emplace_back().add_polyline(polygon);
  if (!hole.empty()) {
    curves.emplace_back().add_polyline(hole);
    curves.back().label = 0;
  }
  return DSC::make_deformable_simplicial_complex_2<Complex>(
      curves, CGAL::parameters::enclosing_box(box).spacing_per_segment(
                  DSC::Construction_options<2>::fine_spacing));
}

// Returns a grid of columns and rows of quadrilaterals, each divided into two triangles.
// `point_at(i, j)` is a vertex, and `label_at(i, j)` is the label of a quadrilateral.
template <class Point_at, class Label_at>
Complex grid(std::size_t columns, std::size_t rows, const Point_at& point_at,
             const Label_at& label_at) {
  std::vector<Complex::Point_2> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<int> labels;
  for (std::size_t j = 0; j <= rows; ++j)
    for (std::size_t i = 0; i <= columns; ++i)
      points.push_back(point_at(i, j));
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) {
      const std::size_t a = i + j * (columns + 1), b = a + columns + 1;
      triangles.push_back({a, a + 1, b + 1});
      triangles.push_back({a, b + 1, b});
      labels.insert(labels.end(), 2, label_at(i, j));
    }
  // Thin rows stay as they are.
  return DSC::make_deformable_simplicial_complex_2<Complex>(
      points, triangles, labels, CGAL::parameters::edge_per_thickness(0.));
}

} // namespace planar_regions

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_2_TEST_PLANAR_REGIONS_H
