// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_SIGNED_UNION_FIND_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_SIGNED_UNION_FIND_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

// Disjoint sets whose members are on one of two sides: of each two of a set, whether they are on
// the same one is known.
class Signed_union_find
{
public:
  explicit Signed_union_find(std::size_t size) : m_parents(size), m_opposite(size, 0) {
    std::iota(m_parents.begin(), m_parents.end(), std::size_t(0));
  }

  // The representative of a set, and whether i is on the other side than it.
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

  // Unites two sets, if they are not one already.
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
  std::vector<char> m_opposite; // to the parent
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_SIGNED_UNION_FIND_H
