// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_CONVERSION_VOXEL_OCTREE_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_CONVERSION_VOXEL_OCTREE_3_H

#include <CGAL/Deformable_simplicial_complex_3/internal/conversion/Voxel_pyramid_3.h>
#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Whole coordinates below 2^21 in one number. Others give the numbers of none of these, as long as
// those do not reach 2^21 - 1.
using Grid_place_3 = std::array<std::uint32_t, 3>;
inline constexpr unsigned grid_coordinate_bits = 21;

inline std::uint64_t grid_key(const Grid_place_3& p) {
  return p[0] | std::uint64_t(p[1]) << grid_coordinate_bits |
         std::uint64_t(p[2]) << 2 * grid_coordinate_bits;
}

inline Grid_place_3 grid_place(std::uint64_t key) {
  static constexpr std::uint64_t mask = (std::uint64_t(1) << grid_coordinate_bits) - 1;
  return {std::uint32_t(key & mask), std::uint32_t(key >> grid_coordinate_bits & mask),
          std::uint32_t(key >> 2 * grid_coordinate_bits)};
}

// An octree over the components of voxels and the space around them. Leaves at the interface are
// the blocks of a pyramid that are not mixed; others are blocks of one component, the larger the
// farther away. Leaves that touch differ by one level at the most.
class Voxel_octree_3
{
public:
  // Of a corner, in voxels, or of a block, in sides of blocks of its level.
  using Place = Grid_place_3;

  // A level l has blocks with sides of 2^l voxels; the root has the last level.
  static constexpr unsigned most_levels = 20;

  // The root is at least so many voxels long, if possible, and has the voxels in its middle.
  Voxel_octree_3(const Voxel_pyramid_3& pyramid, double least_side) : m_pyramid(pyramid) {
    const std::size_t longest = *std::max_element(pyramid.size(0).begin(), pyramid.size(0).end());
    if (longest > (std::size_t(1) << most_levels))
      throw Error("the image has more than 2^20 voxels in a row: divide it");
    while ((std::size_t(1) << m_levels) < longest || m_levels <= pyramid.last_level() ||
           (m_levels < most_levels && double(std::size_t(1) << m_levels) < least_side))
      ++m_levels;
    const std::size_t margin = pyramid.margin(); // which divides all sides
    for (int axis = 0; axis < 3; ++axis)
      m_first[axis] = std::uint32_t((side() - pyramid.size(0)[axis]) / 2 / margin * margin);
    m_split.resize(m_levels + 1);
    split_mixed_blocks();
    split_at_interfaces();
    for (unsigned level = 1; level < m_levels; ++level)
      split_around(level);
  }

  std::uint32_t side() const { return 1u << m_levels; }
  // Where the box of the labels begins.
  std::uint32_t first(int axis) const { return m_first[axis] + std::uint32_t(m_pyramid.margin()); }

  bool is_split(unsigned level, const Place& block) const {
    return level > 0 &&
           std::binary_search(m_split[level].begin(), m_split[level].end(), grid_key(block));
  }

  // Calls visit(level, block, component).
  template <class Visit> void for_each_leaf(const Visit& visit) const {
    for (unsigned level = m_levels; level > 0; --level)
      for (const std::uint64_t parent : m_split[level]) {
        Progress_scope::check();
        for (unsigned child = 0; child < 8; ++child) {
          Place block = grid_place(parent);
          for (int axis = 0; axis < 3; ++axis)
            block[axis] = 2 * block[axis] + (child >> axis & 1);
          if (!is_split(level - 1, block))
            visit(level - 1, block, component(level - 1, block));
        }
      }
  }

private:
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

  // Calls visit(place) for places below `size`.
  template <class Visit>
  static void for_each_place(const Voxel_pyramid_3::Place& size, const Visit& visit) {
    Voxel_pyramid_3::Place p;
    for (p[2] = 0; p[2] < size[2]; ++p[2])
      for (p[1] = 0; p[1] < size[1]; ++p[1]) {
        Progress_scope::check();
        for (p[0] = 0; p[0] < size[0]; ++p[0])
          visit(p);
      }
  }

  // The block of a level that a block of the pyramid at another one is in.
  std::uint64_t block_of(const Voxel_pyramid_3::Place& p, unsigned from, unsigned level) const {
    Place result;
    for (int axis = 0; axis < 3; ++axis)
      result[axis] = std::uint32_t((m_first[axis] >> from) + p[axis]) >> (level - from);
    return grid_key(result);
  }

  void split_mixed_blocks() {
    for (unsigned level = 1; level <= m_pyramid.last_level(); ++level)
      for_each_place(m_pyramid.size(level), [&](const Voxel_pyramid_3::Place& p) {
        if (m_pyramid(level, p) == Voxel_pyramid_3::mixed)
          m_split[level].push_back(block_of(p, level, level));
      });
  }

  // No leaf around a vertex where several components meet is larger than blocks of the pyramid:
  // lengths of edges of the interface are bounded.
  void split_at_interfaces() {
    const unsigned last = m_pyramid.last_level();
    auto vertices = m_pyramid.size(last);
    for (std::size_t& n : vertices)
      --n;
    for_each_place(vertices, [&](const Voxel_pyramid_3::Place& p) {
      const auto block = [&](std::size_t i) {
        return Voxel_pyramid_3::Place{p[0] + (i & 1), p[1] + (i >> 1 & 1), p[2] + (i >> 2)};
      };
      const int component = m_pyramid(last, p);
      bool is_same = component != Voxel_pyramid_3::mixed;
      for (std::size_t i = 1; i < 8 && is_same; ++i)
        is_same = m_pyramid(last, block(i)) == component;
      for (std::size_t i = 0; i < 8 && !is_same; ++i)
        m_split[last + 1].push_back(block_of(block(i), last, last + 1));
    });
  }

  // The blocks around those split at a level exist: their parents are split.
  void split_around(unsigned level) {
    sort(m_split[level]);
    const std::uint32_t end = 1u << (m_levels - level);
    for (const std::uint64_t block : m_split[level]) {
      Progress_scope::check();
      const Place p = grid_place(block);
      Place q;
      for (q[2] = p[2] - (p[2] > 0); q[2] <= p[2] + 1 && q[2] < end; ++q[2])
        for (q[1] = p[1] - (p[1] > 0); q[1] <= p[1] + 1 && q[1] < end; ++q[1])
          for (q[0] = p[0] - (p[0] > 0); q[0] <= p[0] + 1 && q[0] < end; ++q[0])
            m_split[level + 1].push_back(grid_key({q[0] / 2, q[1] / 2, q[2] / 2}));
    }
    sort(m_split[level + 1]);
  }

  static void sort(std::vector<std::uint64_t>& keys) {
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  }

  const Voxel_pyramid_3& m_pyramid;
  unsigned m_levels = 1;
  Place m_first;                                   // of the voxels of the pyramid, in the root
  std::vector<std::vector<std::uint64_t>> m_split; // keys of blocks, for each level
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_CONVERSION_VOXEL_OCTREE_3_H
