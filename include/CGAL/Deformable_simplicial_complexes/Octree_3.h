// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_OCTREE_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_OCTREE_3_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>
#include <CGAL/Deformable_simplicial_complexes/stoppable_sort.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

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

// An octree whose leaves differ by one level at the most where they touch. Blocks are first marked
// to be split, then the tree is completed.
class Octree_3
{
public:
  // Of a corner, in units, or of a block, in sides of blocks of its level.
  using Place = Grid_place_3;

  // A level l has blocks with sides of 2^l units; the root, which is split, has the last level.
  static constexpr unsigned most_levels = 20;

  explicit Octree_3(unsigned last_level) : m_split(last_level + 1) {
    m_split.back().push_back(grid_key({0, 0, 0}));
  }

  unsigned last_level() const { return unsigned(m_split.size() - 1); }
  std::uint32_t side() const { return 1u << last_level(); }

  // Marks a block of a level above 0. Before the tree is completed.
  void split(unsigned level, const Place& block) { m_split[level].push_back(grid_key(block)); }

  // Splits further blocks until leaves that touch differ by one level at the most.
  void complete() {
    for (unsigned level = 1; level < last_level(); ++level) {
      sort_and_unify(m_split[level]);
      split_around(level);
    }
    sort_and_unify(m_split.back());
  }

  bool is_split(unsigned level, const Place& block) const {
    return level > 0 &&
           std::binary_search(m_split[level].begin(), m_split[level].end(), grid_key(block));
  }

  // Calls visit(level, block).
  template <class Visit> void for_each_leaf(const Visit& visit) const {
    for (unsigned level = last_level(); level > 0; --level)
      for (const std::uint64_t parent : m_split[level]) {
        Progress_scope::check();
        for (unsigned child = 0; child < 8; ++child) {
          Place block = grid_place(parent);
          for (int axis = 0; axis < 3; ++axis)
            block[axis] = 2 * block[axis] + (child >> axis & 1);
          if (!is_split(level - 1, block))
            visit(level - 1, block);
        }
      }
  }

private:
  // The blocks around those split at a level exist: their parents are split.
  void split_around(unsigned level) {
    const std::uint32_t end = 1u << (last_level() - level);
    for (const std::uint64_t block : m_split[level]) {
      Progress_scope::check();
      const Place p = grid_place(block);
      Place q;
      for (q[2] = p[2] - (p[2] > 0); q[2] <= p[2] + 1 && q[2] < end; ++q[2])
        for (q[1] = p[1] - (p[1] > 0); q[1] <= p[1] + 1 && q[1] < end; ++q[1])
          for (q[0] = p[0] - (p[0] > 0); q[0] <= p[0] + 1 && q[0] < end; ++q[0])
            split(level + 1, {q[0] / 2, q[1] / 2, q[2] / 2});
    }
  }

  std::vector<std::vector<std::uint64_t>> m_split; // keys of blocks, for each level
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_OCTREE_3_H
