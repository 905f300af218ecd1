// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_SUPPORT_INTERNAL_SETS_DISJOINT_SETS_H
#define CGAL_MESH_SUPPORT_INTERNAL_SETS_DISJOINT_SETS_H

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

// Partition of the numbers below a size into disjoint sets. The representative of a set is its
// least element, so it does not depend on the order of the unions. Both functions take amortized
// logarithmic time. Only one thread at a time can use an object, because `find()` also changes it.
class Disjoint_sets
{
public:
  // Constructs `size` sets of one element each.
  explicit Disjoint_sets(std::size_t size = 0) : m_parents(size) {
    std::iota(m_parents.begin(), m_parents.end(), std::size_t(0));
  }

  // Adds a set of one element. Returns this element.
  std::size_t add() {
    m_parents.push_back(m_parents.size());
    return m_parents.back();
  }

  // Returns the number of elements of all sets.
  std::size_t size() const { return m_parents.size(); }

  // Returns the least element of the set of `i`. \pre `i` is less than the size.
  std::size_t find(std::size_t i) {
    while (m_parents[i] != i)
      i = m_parents[i] = m_parents[m_parents[i]];
    return i;
  }

  // Unites the sets of `i` and `j`. \pre Both are less than the size.
  void join(std::size_t i, std::size_t j) {
    i = find(i);
    j = find(j);
    m_parents[(std::max)(i, j)] = (std::min)(i, j);
  }

private:
  std::vector<std::size_t> m_parents;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_MESH_SUPPORT_INTERNAL_SETS_DISJOINT_SETS_H
