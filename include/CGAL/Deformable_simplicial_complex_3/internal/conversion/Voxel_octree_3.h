// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_CONVERSION_VOXEL_OCTREE_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_CONVERSION_VOXEL_OCTREE_3_H

#include <CGAL/Deformable_simplicial_complex_3/internal/conversion/Voxel_components_3.h>
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

// An octree over the components of voxels and the space around them. Voxels that touch one of
// another component, if only in a vertex, are leaves; other leaves are blocks of one component, the
// larger the farther away. Leaves that touch differ by one level at the most.
class Voxel_octree_3
{
public:
  // Of a corner, in voxels, or of a block, in sides of blocks of its level.
  using Place = Grid_place_3;

  // A level l has blocks with sides of 2^l voxels; the root has the last level.
  static constexpr unsigned most_levels = 20;

  // The root is at least so many voxels long, if possible, and has the voxels in its middle.
  Voxel_octree_3(const Voxel_components_3& components, double least_side)
      : m_components(components) {
    const std::size_t longest =
        *std::max_element(components.size().begin(), components.size().end());
    if (longest > (std::size_t(1) << most_levels))
      throw Error("the image has more than 2^20 voxels in a row: divide it");
    while ((std::size_t(1) << m_levels) < longest ||
           (m_levels < most_levels && double(std::size_t(1) << m_levels) < least_side))
      ++m_levels;
    for (int axis = 0; axis < 3; ++axis)
      m_first[axis] = ((1u << m_levels) - std::uint32_t(components.size()[axis])) / 2;
    m_split.resize(m_levels + 1);
    split_at_interfaces();
    for (unsigned level = 1; level < m_levels; ++level)
      split_around(level);
  }

  std::uint32_t side() const { return 1u << m_levels; }
  // Where the first voxel with a label other than 0 may be, behind the layer around.
  std::uint32_t first(int axis) const { return m_first[axis] + 1; }

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
  // Of the first voxel of a block.
  int component(unsigned level, const Place& block) const {
    Place at;
    for (int axis = 0; axis < 3; ++axis) {
      const std::uint32_t x = block[axis] << level;
      if (x < m_first[axis] || x - m_first[axis] >= m_components.size()[axis])
        return 0;
      at[axis] = x - m_first[axis];
    }
    return m_components(at[0], at[1], at[2]);
  }

  // Blocks of two voxels a side around each vertex of voxels where several components meet.
  void split_at_interfaces() {
    const auto& size = m_components.size();
    for (std::uint32_t z = 1; z < size[2]; ++z)
      for (std::uint32_t y = 1; y < size[1]; ++y) {
        Progress_scope::check();
        for (std::uint32_t x = 1; x < size[0]; ++x) {
          const auto corner = [&](unsigned i) {
            return Place{x - (i & 1), y - (i >> 1 & 1), z - (i >> 2)};
          };
          bool is_same = true;
          for (unsigned i = 1; i < 8 && is_same; ++i) {
            const Place p = corner(i);
            is_same = m_components(p[0], p[1], p[2]) == m_components(x, y, z);
          }
          for (unsigned i = 0; i < 8 && !is_same; ++i) {
            const Place p = corner(i);
            m_split[1].push_back(grid_key(
                {(p[0] + m_first[0]) / 2, (p[1] + m_first[1]) / 2, (p[2] + m_first[2]) / 2}));
          }
        }
      }
    sort(m_split[1]);
  }

  // The blocks around those split at a level exist: their parents are split.
  void split_around(unsigned level) {
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

  const Voxel_components_3& m_components;
  unsigned m_levels = 1;
  Place m_first;                                   // of the padded voxels, in the root
  std::vector<std::vector<std::uint64_t>> m_split; // keys of blocks, for each level
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_CONVERSION_VOXEL_OCTREE_3_H
