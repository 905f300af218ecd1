// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BOOKKEEPING_MARKS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BOOKKEEPING_MARKS_H

#include <CGAL/Mesh_support/internal/threads/Borrowed_table.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A hash table from the ids of a few items to their indices in a list, designed for frequent
// clearing.
class Id_map
{
public:
  static constexpr std::uint32_t none = std::uint32_t(-1);

  void clear() {
    if (m_size == 0)
      return;
    m_slots.resize((std::min)(m_slots.size(), most_kept));
    std::fill(m_slots.begin(), m_slots.end(), Slot());
    m_size = 0;
  }

  std::uint32_t find(std::uint32_t id) const {
    return m_slots.empty() ? none : m_slots[slot_of(id)].place;
  }

  // Inserts an id.
  // \pre The id is not in the map, and `place` is not `none`.
  void insert(std::uint32_t id, std::uint32_t place) {
    if (2 * (m_size + 1) > m_slots.size())
      grow();
    m_slots[slot_of(id)] = {id, place};
    ++m_size;
  }

private:
  struct Slot
  {
    std::uint32_t id = 0, place = none;
  };

  static constexpr std::size_t fewest = 64, most_kept = 256; // numbers of slots, powers of two

  // Returns the slot that contains an id, or the slot where it would be inserted.
  std::size_t slot_of(std::uint32_t id) const {
    static constexpr std::uint32_t golden = 2654435769u; // 2^32 divided by the golden ratio
    const std::size_t mask = m_slots.size() - 1;
    std::size_t slot = std::size_t((id * golden) >> 8) & mask;
    while (m_slots[slot].place != none && m_slots[slot].id != id)
      slot = (slot + 1) & mask;
    return slot;
  }

  void grow() {
    std::vector<Slot> slots((std::max)(fewest, 2 * m_slots.size()));
    m_slots.swap(slots);
    for (const Slot& slot : slots)
      if (slot.place != none)
        m_slots[slot_of(slot.id)] = slot;
  }

  std::vector<Slot> m_slots; // at least half of them are free
  std::size_t m_size = 0;
};

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
