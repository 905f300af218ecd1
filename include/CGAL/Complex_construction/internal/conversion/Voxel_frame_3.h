// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Complex_construction, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_COMPLEX_CONSTRUCTION_INTERNAL_CONVERSION_VOXEL_FRAME_3_H
#define CGAL_COMPLEX_CONSTRUCTION_INTERNAL_CONVERSION_VOXEL_FRAME_3_H

#include <CGAL/Complex_construction/Octree_3.h>
#include <CGAL/Complex_construction/internal/conversion/Voxel_components_3.h>
#include <CGAL/Complex_construction/internal/conversion/Voxel_pyramid_3.h>
#include <CGAL/Mesh_support/Error.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// An octree over the components of voxels and the space around them. Leaves at the interface are
// blocks of a pyramid that are not mixed. Other leaves are blocks of one component, whose size
// increases with the distance from the interface. The unit is the side of a voxel.
class Voxel_octree_3
{
public:
  using Place = Octree_3::Place;

  // Builds an octree with the voxels in the middle of the root. The side of the root is at least
  // `least_side` voxels, if the number of levels allows it. Throws `Error` if the image has more
  // than 2^20 voxels in a row.
  Voxel_octree_3(const Voxel_pyramid_3& pyramid, double least_side)
      : m_pyramid(pyramid), m_tree(last_level(pyramid, least_side)) {
    const std::size_t margin = pyramid.margin(); // divides all side lengths
    for (int axis = 0; axis < 3; ++axis)
      m_first[axis] = std::uint32_t((m_tree.side() - pyramid.size(0)[axis]) / 2 / margin * margin);
    split_mixed_blocks();
    split_at_interfaces();
    m_tree.complete();
  }

  const Octree_3& tree() const { return m_tree; }
  // Returns the first coordinate of the box of labels.
  std::uint32_t first(int axis) const { return m_first[axis] + std::uint32_t(m_pyramid.margin()); }

  // Returns the component of a leaf.
  int component(unsigned level, const Place& block) const {
    const unsigned known = (std::min)(level, m_pyramid.last_level());
    Voxel_pyramid_3::Place at;
    for (int axis = 0; axis < 3; ++axis) {
      const std::uint32_t x = block[axis] << (level - known), first = m_first[axis] >> known;
      if (x < first || x - first >= m_pyramid.size(known)[axis])
        return 0;
      at[axis] = x - first;
    }
    return m_pyramid.component(known, at);
  }

private:
  static unsigned last_level(const Voxel_pyramid_3& pyramid, double least_side) {
    const std::size_t longest = *std::max_element(pyramid.size(0).begin(), pyramid.size(0).end());
    if (longest > (std::size_t(1) << Octree_3::most_levels))
      throw Error("the image has more than 2^20 voxels in a row: divide it");
    unsigned result = 1;
    while ((std::size_t(1) << result) < longest || result <= pyramid.last_level() ||
           (result < Octree_3::most_levels && double(std::size_t(1) << result) < least_side))
      ++result;
    return result;
  }

  // Returns the block of level `level` that contains a block of the pyramid of level `from`.
  Place block_of(const Voxel_pyramid_3::Place& p, unsigned from, unsigned level) const {
    Place result;
    for (int axis = 0; axis < 3; ++axis)
      result[axis] = std::uint32_t((m_first[axis] >> from) + p[axis]) >> (level - from);
    return result;
  }

  void split_mixed_blocks() {
    for (unsigned level = 1; level <= m_pyramid.last_level(); ++level)
      Voxel_pyramid_3::for_each_place(m_pyramid.size(level), [&](const Voxel_pyramid_3::Place& p) {
        if (m_pyramid(level, p) == Voxel_pyramid_3::mixed)
          m_tree.split(level, block_of(p, level, level));
      });
  }

  // Splits blocks so that no leaf at a vertex where several components meet is larger than the
  // largest blocks of the pyramid. This bounds the edge lengths of the interface.
  void split_at_interfaces() {
    const unsigned last = m_pyramid.last_level();
    auto vertices = m_pyramid.size(last);
    for (std::size_t& n : vertices)
      --n;
    Voxel_pyramid_3::for_each_place(vertices, [&](const Voxel_pyramid_3::Place& p) {
      const auto block = [&](std::size_t i) {
        return Voxel_pyramid_3::Place{p[0] + (i & 1), p[1] + (i >> 1 & 1), p[2] + (i >> 2)};
      };
      const int component = m_pyramid(last, p);
      bool is_same = component != Voxel_pyramid_3::mixed;
      for (std::size_t i = 1; i < 8 && is_same; ++i)
        is_same = m_pyramid(last, block(i)) == component;
      for (std::size_t i = 0; i < 8 && !is_same; ++i)
        m_tree.split(last + 1, block_of(block(i), last, last + 1));
    });
  }

  const Voxel_pyramid_3& m_pyramid;
  Octree_3 m_tree;
  Place m_first; // of the voxels of the pyramid, in the root
};

// The frame in which a complex of voxels is built: p = translation + scale * q for a point p of the
// image and the corresponding point q of the complex. Computations use side lengths of voxels as
// unit, so that small units of the image do not cause underflow. If voxels fill the domain, the
// space around them is removed, and the domain that is given is not used.
class Voxel_frame_3
{
public:
  // Computes the frame. Normalization maps to [-1,1]^3 the cube with the center of the box of
  // labels and half side 2.5 r, where r is half the diagonal of that box. Throws `Error` if the
  // size of the voxels is zero or not finite, or if the domain does not contain them in its
  // interior.
  // \pre the voxels fill the domain, or a domain is given
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
      const auto [low, high] = voxels.fills_domain ? Limits{-1, 1} : limits(*domain, axis);
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

  double m_unit;                       // half the side of that cube, in the unit of the image
  std::array<double, 3> m_center;      // of the box of labels, in the coordinates of the image
  std::array<double, 3> m_half;        // half the side lengths of that box, in voxels
  std::array<double, 3> m_side;        // of voxels, in `m_unit`
  std::array<double, 3> m_low, m_high; // the domain relative to `m_center`, in `m_unit`
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_COMPLEX_CONSTRUCTION_INTERNAL_CONVERSION_VOXEL_FRAME_3_H
