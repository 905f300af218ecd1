// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_PYTHON_SPACE_H
#define DSC_PYTHON_SPACE_H

#include "arrays.h"

#include <CGAL/Mesh_support/coordinates.h>
#include <CGAL/Origin.h>

#include <tuple>

namespace dsc_python {

/// Returns the rows of an array of shape (n, d) as points of a complex, which has no units yet.
template <class Complex>
std::vector<typename Complex::Point> input_points(const Array<double>& array,
                                                  const std::string& name) {
  std::vector<typename Complex::Point> result;
  for (const auto& row : rows_of<double, Complex::dimension>(array, name))
    std::apply([&](auto... coordinates) { result.emplace_back(coordinates...); }, row);
  return result;
}

/// Conversion of coordinates between a complex, which may be normalized, and the user.
template <class Complex> class Space
{
public:
  static constexpr int d = Complex::dimension;
  using Point = typename Complex::Point;
  using Vector = typename Complex::Vector;

  explicit Space(const Complex& complex) : m_normalization(complex.normalization()) {}

  double scale() const { return m_normalization.scale; }
  /// Returns an area in the plane or a volume in space, in units of the user.
  double measure(double measure) const { return measure * std::pow(scale(), d); }

  Point to_user(const Point& p) const {
    return CGAL::ORIGIN + (m_normalization.translation + scale() * (p - CGAL::ORIGIN));
  }
  Point from_user(const Point& p) const {
    return CGAL::ORIGIN + ((p - CGAL::ORIGIN) - m_normalization.translation) / scale();
  }
  Vector from_user(const Vector& v) const { return v / scale(); }

  /// Returns positions as an array of shape (n, d).
  py::array_t<double> array(const std::vector<Point>& points) const {
    return array_of<double>(
        points.size(), d, [&](std::size_t i, std::size_t j) { return to_user(points[i])[int(j)]; });
  }

  /// Returns the points of an array of shape (n, d).
  std::vector<Point> points(const Array<double>& array, const std::string& name) const {
    std::vector<Point> result;
    for (const auto& row : rows_of<double, d>(array, name))
      result.push_back(from_user(CGAL::Deformable_simplicial_complexes::point_at<Complex>(row)));
    return result;
  }

private:
  typename Complex::Normalization m_normalization;
};

} // namespace dsc_python

#endif // DSC_PYTHON_SPACE_H
