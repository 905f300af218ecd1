// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_SUPPORT_INTERNAL_SETS_SIGNED_UNION_FIND_H
#define CGAL_MESH_SUPPORT_INTERNAL_SETS_SIGNED_UNION_FIND_H

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

// Partition of the numbers below a size into disjoint sets in which each element has a sign
// relative to the other elements: any two elements of a set are on the same side or on opposite
// sides. An example is the consistent orientation of facets. The representative of a set is its
// least element. Both functions take amortized logarithmic time. Only one thread at a time can use
// an object, because `find()` also changes it.
class Signed_union_find
{
public:
  // Constructs `size` sets of one element each.
  explicit Signed_union_find(std::size_t size) : m_parents(size), m_opposite(size, 0) {
    std::iota(m_parents.begin(), m_parents.end(), std::size_t(0));
  }

  // Returns the representative of the set of `i`, and whether `i` is on the opposite side.
  // \pre `i` is less than the size.
  std::pair<std::size_t, bool> find(std::size_t i) {
    std::size_t root = i;
    char opposite = 0;
    for (; m_parents[root] != root; root = m_parents[root])
      opposite ^= m_opposite[root];
    const bool result = opposite;
    while (m_parents[i] != root && i != root) {
      const std::size_t parent = m_parents[i];
      const char next = char(opposite ^ m_opposite[i]);
      m_parents[i] = root;
      m_opposite[i] = opposite;
      opposite = next;
      i = parent;
    }
    return {root, result};
  }

  // Unites the sets of `i` and `j` such that both elements are on the same side or, if
  // `are_opposite`, on opposite sides. Has no effect if they are in one set, even if their sides
  // there contradict `are_opposite`; use `find()` to detect this.
  // \pre Both are less than the size.
  void unite(std::size_t i, std::size_t j, bool are_opposite) {
    const auto a = find(i), b = find(j);
    if (a.first == b.first)
      return;
    const bool keeps = a.first < b.first;
    const std::size_t root = keeps ? a.first : b.first, child = keeps ? b.first : a.first;
    m_parents[child] = root;
    m_opposite[child] = char(a.second ^ b.second ^ are_opposite);
  }

private:
  std::vector<std::size_t> m_parents;
  std::vector<char> m_opposite; // whether an element and its parent are on opposite sides
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_MESH_SUPPORT_INTERNAL_SETS_SIGNED_UNION_FIND_H
