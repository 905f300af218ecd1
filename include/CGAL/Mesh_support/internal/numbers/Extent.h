// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_SUPPORT_INTERNAL_NUMBERS_EXTENT_H
#define CGAL_MESH_SUPPORT_INTERNAL_NUMBERS_EXTENT_H

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The smallest axis-aligned box in d dimensions that contains given points.
template <int d> class Extent
{
public:
  Extent() {
    m_lower.fill(std::numeric_limits<double>::infinity());
    m_upper.fill(-std::numeric_limits<double>::infinity());
  }

  template <class Point> void add(const Point& p) {
    for (int axis = 0; axis < d; ++axis) {
      m_lower[axis] = (std::min)(m_lower[axis], double(p[axis]));
      m_upper[axis] = (std::max)(m_upper[axis], double(p[axis]));
    }
  }

  // Returns whether the longest side is in a range in which products of several lengths neither
  // overflow nor underflow.
  bool is_measurable() const {
    // The products have up to three factors.
    static constexpr double shortest = 1e-30, longest = 1e30;
    return longest_side() >= shortest && longest_side() <= longest;
  }

  double longest_side() const {
    double result = 0;
    for (int axis = 0; axis < d; ++axis)
      result = (std::max)(result, m_upper[axis] - m_lower[axis]);
    return result;
  }

  // Returns the coordinates of a point in units of the longest side, from the lower corner.
  template <class Point> std::array<double, d> in_unit_cube(const Point& p) const {
    const double side = longest_side();
    std::array<double, d> result;
    for (int axis = 0; axis < d; ++axis)
      result[axis] = side > 0 ? (p[axis] - m_lower[axis]) / side : 0;
    return result;
  }

  // Returns the sides of the box that a point lies on, as the bits of a `Boundary_class`.
  template <class Point> std::uint8_t sides(const Point& p) const {
    int bits = 0;
    for (int axis = 0; axis < d; ++axis) {
      bits |= p[axis] == m_lower[axis] ? 1 << (2 * axis) : 0;
      bits |= p[axis] == m_upper[axis] ? 2 << (2 * axis) : 0;
    }
    return std::uint8_t(bits);
  }

  double lower(int axis) const { return m_lower[axis]; }
  double upper(int axis) const { return m_upper[axis]; }

  // Returns the area or the volume of the box.
  double measure() const {
    double result = 1;
    for (int axis = 0; axis < d; ++axis)
      result *= m_upper[axis] - m_lower[axis];
    return result;
  }

private:
  std::array<double, d> m_lower, m_upper;
};

template <int d, class Points> Extent<d> extent_of(const Points& points) {
  Extent<d> result;
  for (const auto& p : points)
    result.add(p);
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_SUPPORT_INTERNAL_NUMBERS_EXTENT_H
