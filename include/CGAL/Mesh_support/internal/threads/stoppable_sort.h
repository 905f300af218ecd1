// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_SUPPORT_INTERNAL_THREADS_STOPPABLE_SORT_H
#define CGAL_MESH_SUPPORT_INTERNAL_THREADS_STOPPABLE_SORT_H

#include <CGAL/Mesh_support/Progress_scope.h>

#include <algorithm>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// A counter that checks for an interrupt once in many steps, for loops whose steps are faster than
// the check.
class Sparse_check
{
public:
  void operator()() {
    static constexpr unsigned period = 1 << 12; // steps between two checks
    if (++m_steps % period == 0)
      Progress_scope::check();
  }

private:
  unsigned m_steps = 0;
};

} // namespace internal

// Sorts a range by `operator<`, as `std::sort()` does, and calls `Progress_scope::check()` at
// intervals. n log n in the size of the range.
//
// \throws Interrupted_error if a `Progress_scope` stops the function. The elements of the range are
//         then valid but unspecified: elements can be missing or duplicate.
template <class Iterator> void stoppable_sort(Iterator first, Iterator last) {
  internal::Sparse_check check;
  std::sort(first, last, [&](const auto& a, const auto& b) {
    check();
    return a < b;
  });
}

// Sorts items by `operator<` and removes duplicates. n log n in their number.
//
// \throws Interrupted_error if a `Progress_scope` stops the function. The number of items is then
//         unchanged, and their values are unspecified.
template <class Item> void sort_and_unify(std::vector<Item>& items) {
  stoppable_sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_MESH_SUPPORT_INTERNAL_THREADS_STOPPABLE_SORT_H
