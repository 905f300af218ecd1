// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_IMAGE_SEGMENTATION_INTERNAL_MOMENTS_PIXEL_SUMS_2_H
#define CGAL_IMAGE_SEGMENTATION_INTERNAL_MOMENTS_PIXEL_SUMS_2_H

#include <CGAL/Image_segmentation/Gray_image.h>
#include <CGAL/Mesh_support/Progress_scope.h>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// A part of a segment, as fractions of the segment. It is empty unless `from` is less than `to`.
struct Segment_part
{
  double from = 0, to = 1;
};

// Returns the intersection of a part of a segment with the points whose coordinate is in [0, size].
// The ends of the segment have the coordinates `p` and `q`.
inline Segment_part clip(Segment_part part, double p, double q, double size) {
  if (p == q)
    return p >= 0 && p <= size ? part : Segment_part{0, 0};
  const double a = -p / (q - p), b = (size - p) / (q - p);
  return {(std::max)(part.from, (std::min)(a, b)), (std::min)(part.to, (std::max)(a, b))};
}

// Calls visit(from, to) for the pieces of a part of a segment between lines of the pixel grid, as
// fractions of the segment. The part must be inside the image.
template <class Visit>
void for_each_pixel_piece(const std::array<double, 2>& p, const std::array<double, 2>& q,
                          const Segment_part& part, const Visit& visit) {
  std::array<double, 2> next, line, direction; // fraction at the next line of each axis
  const auto fraction = [&](std::size_t axis) {
    return (line[axis] - p[axis]) / (q[axis] - p[axis]);
  };
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double length = q[axis] - p[axis], begin = p[axis] + part.from * length;
    direction[axis] = length < 0 ? -1 : 1;
    line[axis] = length < 0 ? std::ceil(begin) - 1 : std::floor(begin) + 1;
    next[axis] = length == 0 ? 2 : fraction(axis);
  }
  for (double at = part.from; at < part.to;) {
    const std::size_t axis = next[0] <= next[1] ? 0 : 1;
    const double to = (std::min)(next[axis], part.to);
    if (to > at)
      visit(at, to);
    at = (std::max)(at, to);
    if (at < part.to) {
      line[axis] += direction[axis];
      next[axis] = fraction(axis);
    }
  }
}

// Exact integrals of the fields of an image over triangles: the mask, the sum of the squares of all
// channels, and each channel. Coordinates are in pixels: pixel (i, j) is the square from (i, j) to
// (i + 1, j + 1). Values outside the image are 0.
//
// The integral over a triangle equals the integral of S dy along its boundary, where S(x, y) is the
// integral of the field from 0 to x in the row of y. Between two lines of the pixel grid, S is
// linear along an edge.
class Pixel_sums_2
{
public:
  using Point = std::array<double, 2>;

  explicit Pixel_sums_2(const Gray_image<2>& image)
      : m_width(image.grid.size[0]), m_height(image.grid.size[1]),
        m_fields(image.channels.size() + 2), m_sums((m_width + 1) * m_height * m_fields) {
    std::vector<double> value(m_fields);
    for (std::size_t y = 0; y < m_height; ++y) {
      Progress_scope::check();
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
  }

  // Adds the integrals over a triangle to `result`, an entry for each field. Positive if the
  // corners are counterclockwise.
  void add(const std::array<Point, 3>& corners, double* result) const {
    for (std::size_t i = 0; i < 3; ++i)
      add_edge(corners[i], corners[(i + 1) % 3], result);
  }

private:
  void add_edge(Point p, Point q, double* result) const {
    const Segment_part rows = clip({}, p[1], q[1], double(m_height));
    if (p[1] == q[1] || !(rows.from < rows.to))
      return;
    // To the left of the image, S is 0. To the right, it depends on y only.
    const double width = double(m_width);
    const Segment_part inside = clip(rows, p[0], q[0], width);
    if (inside.from < inside.to)
      add_part(p, q, inside, result);
    const auto add_right = [&](const Segment_part& part) {
      if (part.from < part.to && p[0] + (part.from + part.to) / 2 * (q[0] - p[0]) > width)
        add_part({width, p[1]}, {width, q[1]}, part, result);
    };
    if (inside.from < inside.to) {
      add_right({rows.from, inside.from});
      add_right({inside.to, rows.to});
    } else
      add_right(rows);
  }

  void add_part(const Point& p, const Point& q, const Segment_part& part, double* result) const {
    for_each_pixel_piece(p, q, part, [&](double from, double to) {
      const double middle = (from + to) / 2, dy = (q[1] - p[1]) * (to - from);
      const double y = std::clamp(p[1] + middle * (q[1] - p[1]), 0., double(m_height)),
                   x = std::clamp(p[0] + middle * (q[0] - p[0]), 0., double(m_width));
      const auto row = (std::min)(std::size_t(y), m_height - 1),
                 column = (std::min)(std::size_t(x), m_width - 1);
      const double of_pixel = x - double(column);
      const double* left = m_sums.data() + (row * (m_width + 1) + column) * m_fields;
      for (std::size_t f = 0; f < m_fields; ++f)
        result[f] += dy * (left[f] + of_pixel * (left[f + m_fields] - left[f]));
    });
  }

  std::size_t m_width, m_height, m_fields;
  std::vector<double> m_sums; // of the pixels to the left, for each row, place and field
};

} // namespace internal

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_IMAGE_SEGMENTATION_INTERNAL_MOMENTS_PIXEL_SUMS_2_H
