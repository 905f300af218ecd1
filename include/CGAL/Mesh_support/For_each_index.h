// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_SUPPORT_FOR_EACH_INDEX_H
#define CGAL_MESH_SUPPORT_FOR_EACH_INDEX_H

#include <algorithm>
#include <cstddef>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgMeshSupportRef

Parallel loop over indices. It uses several threads if the program is linked with TBB; otherwise, it
is a sequential loop. If the calls are independent of each other, the results are bitwise identical
for any number of threads.

The threads are kept between the loops of an object. An object cannot be copied.
*/
class For_each_index
{
public:
  /// Constructs a loop. Threads start with the first loop that needs them.
  /// \param number_of_threads the number of threads, which is clamped to [1, 1024]
  explicit For_each_index(unsigned number_of_threads = 1)
      : m_number_of_threads(
            (std::max)(1u, (std::min)(number_of_threads, maximum_number_of_threads))) {}

  For_each_index(const For_each_index&) = delete;
  For_each_index& operator=(const For_each_index&) = delete;

  /// Returns the number of threads. Without TBB, the loop does not use them.
  unsigned number_of_threads() const { return m_number_of_threads; }

  /// Calls `function(i)` once for each index `i` in [0, `n`), in any order.
  /// \param n number of indices
  /// \param function function object, callable as `const`
  /// \param worthwhile the loop is sequential for fewer indices. Use a smaller value for long
  ///        calls, because the start of a parallel loop costs as much as many short calls.
  /// \pre Calls of `function` for different indices can run at once and are independent of each
  ///      other. Only one thread at a time calls this function of an object.
  /// \note An exception of `function` passes through. Some of the other calls are then missing.
  ///       The scopes of `Progress_scope` belong to the calling thread; other threads of the loop
  ///       do not call their callbacks.
  template <class Function>
  void operator()(std::size_t n, const Function& function, std::size_t worthwhile = 2000) const {
    const auto run_range = [&function](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
        function(i);
    };
#ifdef CGAL_LINKED_WITH_TBB
    if (m_number_of_threads > 1 && n >= worthwhile) {
      using Run_range = decltype(run_range);
      share(n, &run_range, [](const void* run, std::size_t first, std::size_t last) {
        (*static_cast<const Run_range*>(run))(first, last);
      });
      return;
    }
#else
    static_cast<void>(worthwhile);
#endif
    run_range(0, n);
  }

private:
  static constexpr unsigned maximum_number_of_threads = 1024;

#ifdef CGAL_LINKED_WITH_TBB
  // Runs ranges of [0, n) in the threads. No template, because the loops of TBB take long to
  // compile.
  void share(std::size_t n, const void* run,
             void (*run_range)(const void*, std::size_t, std::size_t)) const {
    if (!m_arena.is_active())
      m_arena.initialize(static_cast<int>(m_number_of_threads));
    m_arena.execute([&] {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n),
                        [&](const tbb::blocked_range<std::size_t>& range) {
                          run_range(run, range.begin(), range.end());
                        });
    });
  }
#endif

  unsigned m_number_of_threads;
#ifdef CGAL_LINKED_WITH_TBB
  mutable tbb::task_arena m_arena; // kept, because its construction takes longer than a loop
#endif
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_MESH_SUPPORT_FOR_EACH_INDEX_H
