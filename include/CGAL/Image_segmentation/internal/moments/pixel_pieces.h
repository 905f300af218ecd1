// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Image_segmentation, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IMAGE_SEGMENTATION_INTERNAL_MOMENTS_PIXEL_PIECES_H
#define CGAL_IMAGE_SEGMENTATION_INTERNAL_MOMENTS_PIXEL_PIECES_H

#include <CGAL/license/Image_segmentation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Deformable_simplicial_complexes::internal {

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

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_IMAGE_SEGMENTATION_INTERNAL_MOMENTS_PIXEL_PIECES_H
