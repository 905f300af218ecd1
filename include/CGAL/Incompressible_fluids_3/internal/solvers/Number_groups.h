// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Incompressible_fluids_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_NUMBER_GROUPS_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_NUMBER_GROUPS_H

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A partition of the numbers from 0 to `size() - 1` into groups (union-find).
class Number_groups
{
public:
  explicit Number_groups(std::size_t size) : m_parents(size) {
    std::iota(m_parents.begin(), m_parents.end(), std::size_t(0));
  }
  std::size_t size() const { return m_parents.size(); }
  // Returns the representative of the group of i.
  std::size_t of(std::size_t i) {
    while (m_parents[i] != i)
      i = m_parents[i] = m_parents[m_parents[i]];
    return i;
  }
  // Unites the groups of i and j.
  void join(std::size_t i, std::size_t j) { m_parents[of(i)] = of(j); }

private:
  std::vector<std::size_t> m_parents;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_NUMBER_GROUPS_H
