// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_OCTREE_3_H
#define CGAL_COMPLEX_CONSTRUCTION_OCTREE_3_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/internal/threads/stoppable_sort.h>

#include <array>
#include <cstdint>

namespace CGAL::Deformable_simplicial_complexes {

/// \ingroup PkgComplexConstructionRef
/// Three integer coordinates.
using Grid_place_3 = std::array<std::uint32_t, 3>;
/// \ingroup PkgComplexConstructionRef
/// Number of bits of each coordinate in a key of `grid_key()`.
inline constexpr unsigned grid_coordinate_bits = 21;

/*!
\ingroup PkgComplexConstructionRef

Returns the key of three coordinates: one number with 21 bits for each coordinate. Keys are ordered
by the last coordinate first. Different places have different keys if all coordinates are less than
2<sup>21</sup>. A place next to the grid can have coordinates -1, as unsigned numbers. Its key
differs from the keys of all places whose coordinates are less than 2<sup>21</sup> - 1. Constant
time.

\pre Each coordinate is less than 2<sup>21</sup>, or -1 as an unsigned number.
*/
inline std::uint64_t grid_key(const Grid_place_3& p) {
  return p[0] | std::uint64_t(p[1]) << grid_coordinate_bits |
         std::uint64_t(p[2]) << 2 * grid_coordinate_bits;
}

/*!
\ingroup PkgComplexConstructionRef

Returns the coordinates of a key of `grid_key()`. Constant time.
*/
inline Grid_place_3 grid_place(std::uint64_t key) {
  static constexpr std::uint64_t mask = (std::uint64_t(1) << grid_coordinate_bits) - 1;
  return {std::uint32_t(key & mask), std::uint32_t(key >> grid_coordinate_bits & mask),
          std::uint32_t(key >> 2 * grid_coordinate_bits)};
}

/*!
\ingroup PkgComplexConstructionRef

Balanced octree of a cube. The levels of leaves that share a point differ by at most one. The octree
stores only the blocks that are split. Construct the octree, mark blocks by `split()`, and call
`complete()` once; then query the leaves. Only one thread at a time can call functions that are not
`const`.
*/
class Octree_3
{
public:
  /// Coordinates of a corner in units, or of a block in sides of the blocks of its level.
  using Place = Grid_place_3;

  /// The greatest level of a root.
  static constexpr unsigned most_levels = 20;

  /// Constructs an octree whose root is split. A block of level l has sides of 2<sup>l</sup> units.
  /// \param last_level the level of the root, in [1, `most_levels`]
  explicit Octree_3(unsigned last_level) : m_split(last_level + 1) {
    m_split.back().push_back(grid_key({0, 0, 0}));
  }

  /// Returns the level of the root.
  unsigned last_level() const { return unsigned(m_split.size() - 1); }
  /// Returns the side of the root, in units.
  std::uint32_t side() const { return 1u << last_level(); }

  /// Marks a block to be split. The same block can be marked several times. Amortized constant
  /// time.
  /// \pre `level` is in [1, `last_level()`], the block is inside the root, and `complete()` was not
  ///      called.
  void split(unsigned level, const Place& block) { m_split[level].push_back(grid_key(block)); }

  /// Splits further blocks until the octree is balanced. n log n in the number of split blocks.
  /// \param most Once there are more split blocks, the function ends.
  /// \return whether the octree is complete. It must not be used otherwise.
  /// \throws Interrupted_error if a `Progress_scope` stops the function. The object must then not
  ///         be used any more.
  bool complete(std::size_t most = std::size_t(-1)) {
    std::size_t number = 0;
    for (unsigned level = 1; level < last_level(); ++level) {
      sort_and_unify(m_split[level]);
      number += m_split[level].size();
      if (number > most)
        return false;
      split_around(level);
    }
    sort_and_unify(m_split.back());
    return true;
  }

  /// Returns whether a block is split. Blocks of level 0 and blocks outside the root are not. A
  /// coordinate outside can be -1 as an unsigned number. Logarithmic in the number of split blocks.
  /// \pre `complete()` was called.
  bool is_split(unsigned level, const Place& block) const {
    return level > 0 &&
           std::binary_search(m_split[level].begin(), m_split[level].end(), grid_key(block));
  }

  /// Calls `visit(level, block)` for each leaf, by decreasing level. The order is deterministic. n
  /// log n in the number of leaves.
  /// \pre `complete()` was called.
  /// \throws Interrupted_error if a `Progress_scope` stops the function. An exception of `visit`
  ///         passes through.
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
  // Marks the parents of all blocks that touch a split block of a level.
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

  std::vector<std::vector<std::uint64_t>> m_split; // keys of split blocks, for each level
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_COMPLEX_CONSTRUCTION_OCTREE_3_H
