// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BOOKKEEPING_MARKS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BOOKKEEPING_MARKS_H

#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Borrowed_table.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The entry of a marked item, which is valid if its epoch is the current one.
struct Mark
{
  std::uint32_t epoch = 0;
};

// A set of marked vertices or cells, initially empty. Valid as long as no vertex or cell is created
// or removed.
class Marks
{
public:
  // Creates an empty set for ids less than `bound`.
  explicit Marks(std::size_t bound) : m_table(bound) {}

  template <class Handle> bool has(Handle item) const {
    return m_table[item->id()].epoch == m_table.epoch();
  }

  // Marks an item. Returns whether it was not marked before.
  template <class Handle> bool add(Handle item) {
    std::uint32_t& epoch = m_table[item->id()].epoch;
    if (epoch == m_table.epoch())
      return false;
    epoch = m_table.epoch();
    return true;
  }

  // Marks an item, and appends it to the list if it was not marked before.
  template <class Handle> void add(Handle item, std::vector<Handle>& items) {
    if (add(item))
      items.push_back(item);
  }

  template <class Handle> void remove(Handle item) { m_table[item->id()].epoch = 0; }

private:
  Borrowed_table<Mark> m_table;
};

template <class Complex> Marks cell_marks(const Complex& complex) {
  return Marks(complex.cell_id_bound());
}

template <class Complex> Marks vertex_marks(const Complex& complex) {
  return Marks(complex.vertex_id_bound());
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BOOKKEEPING_MARKS_H
