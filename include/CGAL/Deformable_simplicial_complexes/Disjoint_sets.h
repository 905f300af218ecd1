// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DISJOINT_SETS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DISJOINT_SETS_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

// Sets of the numbers below a size. The representative of a set is its least element.
class Disjoint_sets
{
public:
  explicit Disjoint_sets(std::size_t size) : m_parents(size) {
    std::iota(m_parents.begin(), m_parents.end(), std::size_t(0));
  }

  std::size_t find(std::size_t i) {
    while (m_parents[i] != i)
      i = m_parents[i] = m_parents[m_parents[i]];
    return i;
  }

  void join(std::size_t i, std::size_t j) {
    i = find(i);
    j = find(j);
    m_parents[(std::max)(i, j)] = (std::min)(i, j);
  }

private:
  std::vector<std::size_t> m_parents;
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DISJOINT_SETS_H
