// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BOOKKEEPING_BORROWED_TABLE_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BOOKKEEPING_BORROWED_TABLE_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

/*
A table for what an algorithm notes about items, by their ids: queries that walk over a complex thus
write nothing into it, and several threads may ask at once. Each thread keeps its tables for reuse.
Emptying one takes no time: an entry counts only if it is of the epoch of now.

Entry has a member `epoch` of type std::uint32_t, 0 at first.
*/
template <class Entry> class Borrowed_table
{
public:
  // An empty one, for ids below a bound.
  explicit Borrowed_table(std::size_t bound) {
    if (!Tables::are_gone && !Tables::of_thread().empty()) {
      m_table = std::move(Tables::of_thread().back());
      Tables::of_thread().pop_back();
    }
    if (m_table.entries.size() < bound)
      m_table.entries.resize(bound);
    if (++m_table.epoch == 0) {
      std::fill(m_table.entries.begin(), m_table.entries.end(), Entry());
      m_table.epoch = 1;
    }
  }
  Borrowed_table(const Borrowed_table&) = delete;
  Borrowed_table& operator=(const Borrowed_table&) = delete;
  ~Borrowed_table() {
    if (Tables::are_gone)
      return;
    try {
      Tables::of_thread().push_back(std::move(m_table));
    } catch (const std::exception&) { // there is no memory for it to be kept
    }
  }

  std::uint32_t epoch() const { return m_table.epoch; }
  Entry& operator[](std::size_t id) { return m_table.entries[id]; }
  const Entry& operator[](std::size_t id) const { return m_table.entries[id]; }

private:
  struct Table
  {
    std::vector<Entry> entries;
    std::uint32_t epoch = 0;
  };

  // Those of a thread go when it ends, and objects with static lifetime may outlive them.
  struct Tables
  {
    ~Tables() { are_gone = true; }

    static std::vector<Table>& of_thread() {
      static thread_local Tables tables;
      return tables.list;
    }

    std::vector<Table> list;
    static inline thread_local bool are_gone = false;
  };

  Table m_table;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BOOKKEEPING_BORROWED_TABLE_H
