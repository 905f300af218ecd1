// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_FOR_EACH_INDEX_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_FOR_EACH_INDEX_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <algorithm>
#include <cstddef>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace CGAL {
namespace Deformable_simplicial_complexes {

// Calls a function for the indices below n, in any order and, if linked with TBB, on several
// threads. The calls must not depend on each other: then the number of threads changes no bit of
// the results.
class For_each_index
{
public:
  explicit For_each_index(unsigned number_of_threads = 1)
      : m_number_of_threads(
            (std::max)(1u, (std::min)(number_of_threads, maximum_number_of_threads))) {}

  For_each_index(const For_each_index&) = delete;
  For_each_index& operator=(const For_each_index&) = delete;

  unsigned number_of_threads() const { return m_number_of_threads; }

  // Threads are used from `worthwhile` indices on: starting them costs about a thousand small
  // calls.
  template <class Function>
  void operator()(std::size_t n, const Function& function, std::size_t worthwhile = 2000) const {
#ifdef CGAL_LINKED_WITH_TBB
    if (m_number_of_threads > 1 && n >= worthwhile) {
      if (!m_arena.is_active())
        m_arena.initialize(static_cast<int>(m_number_of_threads));
      m_arena.execute([&] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n),
                          [&](const tbb::blocked_range<std::size_t>& range) {
                            for (std::size_t i = range.begin(); i < range.end(); ++i)
                              function(i);
                          });
      });
      return;
    }
#else
    static_cast<void>(worthwhile);
#endif
    for (std::size_t i = 0; i < n; ++i)
      function(i);
  }

private:
  static constexpr unsigned maximum_number_of_threads = 1024;

  unsigned m_number_of_threads;
#ifdef CGAL_LINKED_WITH_TBB
  mutable tbb::task_arena m_arena; // of all calls: making one takes much longer than a call
#endif
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_FOR_EACH_INDEX_H
