// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Complex_construction, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_COMPLEX_CONSTRUCTION_INTERNAL_CONVERSION_VOXEL_FRAME_3_H
#define CGAL_COMPLEX_CONSTRUCTION_INTERNAL_CONVERSION_VOXEL_FRAME_3_H

#include <CGAL/Complex_construction/internal/conversion/Labeled_voxels_3.h>
#include <CGAL/Complex_construction/internal/conversion/Voxel_octree_3.h>
#include <CGAL/Mesh_support/Error.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The frame in which a complex of voxels is built: p = translation + scale * q for a point p of the
// image and the corresponding point q of the complex. The default domain is the cube with the
// center of the box of labels and half side 2.5 r, where r is half the diagonal of that box.
// Computations use side lengths of voxels as unit, so that small units of the image do not cause
// underflow. If voxels fill the domain, the space around them is removed, and any domain is
// allowed.
class Voxel_frame_3
{
public:
  // Computes the frame. Normalization maps the default domain to [-1,1]^3. Throws `Error` if the
  // size of the voxels is zero or not finite, or if the domain does not contain them in its
  // interior.
  Voxel_frame_3(const Labeled_voxels_3& voxels, bool normalize,
                const std::optional<Bbox_3>& domain) {
    double squared_diagonal = 0;
    for (int axis = 0; axis < 3; ++axis) {
      m_side[axis] = voxels.spacing[axis] / voxels.largest_spacing();
      m_half[axis] = .5 * double(voxels.size[axis]);
      squared_diagonal += std::pow(2 * m_half[axis] * m_side[axis], 2);
    }
    const double half_side = 2.5 * .5 * std::sqrt(squared_diagonal);
    m_unit = half_side * voxels.largest_spacing();
    m_center = voxels.center;
    if (!(m_unit > 0) || !std::isfinite(m_unit))
      throw Error(
          "the size of the voxels is 0 or too large for numbers of type double: scale them");
    for (double& side : m_side)
      side /= half_side;
    if (normalize) {
      translation = voxels.center;
      scale = m_unit;
    }
    for (int axis = 0; axis < 3; ++axis) {
      const auto [low, high] =
          voxels.fills_domain || !domain ? Limits{-1, 1} : limits(*domain, axis);
      m_low[axis] = low;
      m_high[axis] = high;
      const double half = m_half[axis] * m_side[axis];
      if (!(low < -half && half < high) || !std::isfinite(low) || !std::isfinite(high))
        throw Error("voxels with labels other than 0 reach the enclosing box or lie outside it: "
                    "use a larger box, or the box of all voxels");
    }
  }

  std::array<double, 3> translation = {0, 0, 0};
  double scale = 1;

  // Returns the longest side of the domain, in voxels.
  double longest_side() const {
    double result = 0;
    for (int axis = 0; axis < 3; ++axis)
      result = (std::max)(result, (m_high[axis] - m_low[axis]) / m_side[axis]);
    return result;
  }

  // Returns the side length of a voxel in the complex.
  double side(int axis) const { return m_side[axis] * (m_unit / scale); }

  // Returns a coordinate of a corner of the octree, in the complex. Voxels with labels keep their
  // shape. The space between these voxels and the sides of the root is stretched to fill the
  // domain.
  double coordinate(const Voxel_octree_3& octree, int axis, std::uint32_t x) const {
    const double first = octree.first(axis), last = first + 2 * m_half[axis],
                 half = m_half[axis] * m_side[axis];
    double result;
    if (x < first)
      result = x == 0 ? m_low[axis] : -half + (m_low[axis] + half) * ((first - x) / first);
    else if (x > last)
      result = x == octree.tree().side()
                   ? m_high[axis]
                   : half + (m_high[axis] - half) * ((x - last) / (octree.tree().side() - last));
    else
      result = (x - first - m_half[axis]) * m_side[axis];
    return scale == m_unit ? result : m_center[axis] + m_unit * result;
  }

private:
  struct Limits
  {
    double low, high;
  };

  Limits limits(const Bbox_3& box, int axis) const {
    return {(box.min(axis) - m_center[axis]) / m_unit, (box.max(axis) - m_center[axis]) / m_unit};
  }

  double m_unit;                  // half the side of the default domain, in the unit of the image
  std::array<double, 3> m_center; // of the box of labels, in the coordinates of the image
  std::array<double, 3> m_half;   // half the side lengths of that box, in voxels
  std::array<double, 3> m_side;   // of voxels, in `m_unit`
  std::array<double, 3> m_low, m_high; // the domain relative to `m_center`, in `m_unit`
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_COMPLEX_CONSTRUCTION_INTERNAL_CONVERSION_VOXEL_FRAME_3_H
