// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_HAS_FINITE_COORDINATES_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_HAS_FINITE_COORDINATES_H

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Whether the three coordinates of a point or vector are numbers.
template <class Coordinates> bool has_finite_coordinates(const Coordinates& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

// Whether the longest side of the bounding box of points is such that products of several lengths
// neither overflow nor underflow.
template <class Points> bool has_measurable_extent(const Points& points) {
  double extent = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto range =
        std::minmax_element(points.begin(), points.end(),
                            [&](const auto& p, const auto& q) { return p[axis] < q[axis]; });
    if (range.first != points.end())
      extent = (std::max)(extent, (*range.second)[axis] - (*range.first)[axis]);
  }
  return extent >= 1e-30 && extent <= 1e30;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_HAS_FINITE_COORDINATES_H
