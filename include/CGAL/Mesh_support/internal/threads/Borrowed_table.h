// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_SUPPORT_INTERNAL_THREADS_BORROWED_TABLE_H
#define CGAL_MESH_SUPPORT_INTERNAL_THREADS_BORROWED_TABLE_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

/*
A table that stores temporary data of an algorithm about items, indexed by their ids. Queries that
traverse a complex thus write nothing into it, and several threads can run queries concurrently.
Each thread keeps its tables for reuse. Clearing a table takes constant time: an entry is valid only
if its epoch is the current one.
`Entry` has a member `epoch` of type `std::uint32_t`, initially 0.
*/
template <class Entry> class Borrowed_table
{
public:
  // Creates an empty table for ids less than `bound`.
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
    } catch (const std::exception&) { // no memory to keep the table
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

  // The tables of a thread are destroyed when it ends; objects with static lifetime may outlive
  // them.
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

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_SUPPORT_INTERNAL_THREADS_BORROWED_TABLE_H
