// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Image_segmentation, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IMAGE_SEGMENTATION_INTERNAL_MOMENTS_PIXEL_SUMS_2_H
#define CGAL_IMAGE_SEGMENTATION_INTERNAL_MOMENTS_PIXEL_SUMS_2_H

#include <CGAL/license/Image_segmentation.h>

#include <CGAL/Image_segmentation/Gray_image.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Exact integrals of the fields of an image over triangles: the mask, the sum of the squares of all
// channels, and each channel. Coordinates are in pixels: pixel (i, j) is the square from (i, j) to
// (i + 1, j + 1). Values outside the image are 0.
//
// The integral over a triangle is that of S dy along its boundary, where S(x, y) is the integral of
// the field from 0 to x in the row of y. Between two lines of the pixel grid, S is linear along an
// edge.
class Pixel_sums_2
{
public:
  using Point = std::array<double, 2>;

  explicit Pixel_sums_2(const Gray_image<2>& image)
      : m_width(image.grid.size[0]), m_height(image.grid.size[1]),
        m_fields(image.channels.size() + 2), m_sums((m_width + 1) * m_height * m_fields) {
    std::vector<double> value(m_fields);
    for (std::size_t y = 0; y < m_height; ++y)
      for (std::size_t x = 0; x < m_width; ++x) {
        const std::size_t pixel = y * m_width + x;
        const bool counts = image.has_value(pixel);
        value[0] = counts ? 1 : 0;
        value[1] = 0;
        for (std::size_t k = 0; k < image.channels.size(); ++k) {
          value[k + 2] = counts ? double(image.channels[k][pixel]) : 0;
          value[1] += value[k + 2] * value[k + 2];
        }
        const std::size_t here = (y * (m_width + 1) + x) * m_fields;
        for (std::size_t f = 0; f < m_fields; ++f)
          m_sums[here + m_fields + f] = m_sums[here + f] + value[f];
      }
  }

  // Adds the integrals over a triangle to `result`, an entry for each field. Positive if the
  // corners are counterclockwise.
  void add(const std::array<Point, 3>& corners, double* result) const {
    for (std::size_t i = 0; i < 3; ++i)
      add_edge(corners[i], corners[(i + 1) % 3], result);
  }

private:
  void add_edge(const Point& p, const Point& q, double* result) const {
    if (p[1] == q[1])
      return;
    for_each_piece(p, q, [&](double from, double to) {
      const double middle = (from + to) / 2, dy = (q[1] - p[1]) * (to - from);
      const double y = p[1] + middle * (q[1] - p[1]);
      if (!(y > 0 && y < double(m_height)))
        return;
      const double x = std::clamp(p[0] + middle * (q[0] - p[0]), 0., double(m_width));
      const auto column = (std::min)(std::size_t(x), m_width - 1);
      const double part = x - double(column);
      const double* left = m_sums.data() + ((std::size_t(y) * (m_width + 1)) + column) * m_fields;
      for (std::size_t f = 0; f < m_fields; ++f)
        result[f] += dy * (left[f] + part * (left[f + m_fields] - left[f]));
    });
  }

public:
  // Calls visit(from, to) for the pieces of a segment between lines of the grid, as fractions of
  // the segment.
  template <class Visit>
  static void for_each_piece(const Point& p, const Point& q, const Visit& visit) {
    std::array<double, 2> next, step; // fractions at the next line of each axis, and between lines
    std::array<double, 2> line, direction;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double length = q[axis] - p[axis];
      direction[axis] = length < 0 ? -1 : 1;
      line[axis] = length < 0 ? std::ceil(p[axis]) - 1 : std::floor(p[axis]) + 1;
      step[axis] = length;
      next[axis] = length == 0 ? 2 : (line[axis] - p[axis]) / length;
    }
    double at = 0;
    while (at < 1) {
      const std::size_t axis = next[0] <= next[1] ? 0 : 1;
      const double to = (std::min)(next[axis], 1.);
      if (to > at)
        visit(at, to);
      at = (std::max)(at, to);
      if (at < 1) {
        line[axis] += direction[axis];
        next[axis] = (line[axis] - p[axis]) / step[axis];
      }
    }
  }

private:
  std::size_t m_width, m_height, m_fields;
  std::vector<double> m_sums; // of the pixels to the left, for each row, place and field
};

} // namespace internal

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_IMAGE_SEGMENTATION_INTERNAL_MOMENTS_PIXEL_SUMS_2_H
