// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_INTERNAL_CONVERSION_VOXEL_FRAME_3_H
#define CGAL_COMPLEX_CONSTRUCTION_INTERNAL_CONVERSION_VOXEL_FRAME_3_H

#include <CGAL/Complex_construction/Octree_3.h>
#include <CGAL/Complex_construction/internal/conversion/Voxel_components_3.h>
#include <CGAL/Complex_construction/internal/conversion/Voxel_pyramid_3.h>
#include <CGAL/Mesh_support/Error.h>

#include <optional>

namespace CGAL::Deformable_simplicial_complexes::internal {

// An octree over the components of voxels and the space around them. Leaves at the interface are
// blocks of a pyramid that are not mixed. Other leaves are blocks of one component, whose size
// increases with the distance from the interface. The unit is the side of a voxel.
class Voxel_octree_3
{
public:
  using Place = Octree_3::Place;

  // Builds an octree with the voxels in the middle of the root, or at its begin if they
  // fill the domain. The side of the root is at least `least_side` voxels, if the number of levels
  // allows it. Throws `Error` if the image has more than 2^20 voxels in a row.
  Voxel_octree_3(const Voxel_pyramid_3& pyramid, double least_side)
      : m_pyramid(pyramid), m_tree(last_level(pyramid, least_side)) {
    const std::size_t margin = pyramid.margin(); // divides all side lengths
    for (int axis = 0; axis < 3; ++axis)
      m_first[axis] = std::uint32_t(
          pyramid.fills_domain() ? least_first(pyramid, axis)
                                 : (m_tree.side() - pyramid.size(0)[axis]) / 2 / margin * margin);
    split_mixed_blocks();
    split_at_interfaces();
    if (pyramid.fills_domain())
      split_at_sides();
    m_tree.complete();
  }

  const Octree_3& tree() const { return m_tree; }
  // Returns the first coordinate of the box of labels.
  std::uint32_t first(int axis) const { return m_first[axis] + std::uint32_t(m_pyramid.margin()); }
  // Returns the voxels along an axis.
  const Padded_row& row(int axis) const { return m_pyramid.row(axis); }

  // Returns the component of a leaf.
  int component(unsigned level, const Place& block) const {
    for (int axis = 0; axis < 3 && m_pyramid.fills_domain(); ++axis)
      if (const std::uint32_t x = block[axis] << level;
          x < first(axis) || x - first(axis) >= row(axis).size())
        return 0;
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
  // Returns the least coordinate of the pyramid in the root for which the sides of the voxels lie
  // between large blocks.
  static std::size_t least_first(const Voxel_pyramid_3& pyramid, int axis) {
    return (std::max)(pyramid.row(axis).block, pyramid.margin()) - pyramid.margin();
  }

  static unsigned last_level(const Voxel_pyramid_3& pyramid, double least_side) {
    std::size_t longest = 0;
    for (int axis = 0; axis < 3; ++axis)
      longest = (std::max)(longest, pyramid.size(0)[axis] +
                                        (pyramid.fills_domain() ? least_first(pyramid, axis) : 0));
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

  // Splits blocks that lie on both sides of a side of the domain.
  void split_at_sides() {
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t block = row(axis).block;
      unsigned level = 0;
      while ((std::size_t(1) << level) < block)
        ++level;
      Voxel_pyramid_3::Place begin, size;
      for (int i = 0; i < 3; ++i) {
        begin[i] = first(i) >> level;
        size[i] = ((first(i) + row(i).size() - 1) >> level) + 1 - begin[i];
      }
      const std::size_t last = size[axis] - 1;
      size[axis] = last == 0 ? 1 : 2; // the first and the last layer
      Voxel_pyramid_3::for_each_place(size, [&](const Voxel_pyramid_3::Place& p) {
        Place parent;
        for (int i = 0; i < 3; ++i)
          parent[i] = std::uint32_t(begin[i] + (i == axis ? p[i] * last : p[i])) / 2;
        m_tree.split(level + 1, parent);
      });
    }
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
  Voxel_frame_3(const Labeled_voxels_3& voxels, bool normalize, const std::optional<Bbox_3>& domain)
      : m_fills_domain(voxels.fills_domain) {
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
    const double first = octree.first(axis);
    if (m_fills_domain)
      return in_complex((octree.row(axis).coordinate(x - first) - m_half[axis]) * m_side[axis],
                        axis);
    const double last = first + 2 * m_half[axis], half = m_half[axis] * m_side[axis];
    double result;
    if (x < first)
      result = x == 0 ? m_low[axis] : -half + (m_low[axis] + half) * ((first - x) / first);
    else if (x > last)
      result = x == octree.tree().side()
                   ? m_high[axis]
                   : half + (m_high[axis] - half) * ((x - last) / (octree.tree().side() - last));
    else
      result = (x - first - m_half[axis]) * m_side[axis];
    return in_complex(result, axis);
  }

private:
  double in_complex(double x, int axis) const {
    return scale == m_unit ? x : m_center[axis] + m_unit * x;
  }

  struct Limits
  {
    double low, high;
  };

  Limits limits(const Bbox_3& box, int axis) const {
    return {(box.min(axis) - m_center[axis]) / m_unit, (box.max(axis) - m_center[axis]) / m_unit};
  }

  bool m_fills_domain;                 // whether the voxels do so
  double m_unit;                       // half the side of that cube, in the unit of the image
  std::array<double, 3> m_center;      // of the box of labels, in the coordinates of the image
  std::array<double, 3> m_half;        // half the side lengths of that box, in voxels
  std::array<double, 3> m_side;        // of voxels, in `m_unit`
  std::array<double, 3> m_low, m_high; // the domain relative to `m_center`, in `m_unit`
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_COMPLEX_CONSTRUCTION_INTERNAL_CONVERSION_VOXEL_FRAME_3_H
