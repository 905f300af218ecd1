// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_ITEM_NUMBERS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_ITEM_NUMBERS_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Small numbers, which are given again when they are taken back.
class Dense_ids
{
public:
  // All that are in use are below.
  std::size_t bound() const { return m_bound; }

  template <class Handle> void give(Handle item) {
    if (m_free.empty()) {
      item->set_id(m_bound++);
    } else {
      item->set_id(m_free.back());
      m_free.pop_back();
    }
  }

  // For so many to be taken back; each that is given makes room for one more.
  void make_room(std::size_t number) {
    if (const std::size_t needed = m_free.size() + number; needed > m_free.capacity())
      m_free.reserve((std::max)(needed, 2 * m_free.capacity()));
  }

  // \pre there is room
  template <class Handle> void take_back(Handle item) noexcept { m_free.push_back(item->id()); }

private:
  std::uint32_t m_bound = 0;
  std::vector<std::uint32_t> m_free;
};

/*
Numbers the items of a complex: by creation, with time stamps, which no two items ever share; and
densely, with ids, by which arrays beside the complex are indexed. Orders come from time stamps:
what has an id depends on what was there before. CGAL gives time stamps, too; but CGAL 6 gives what
is created in place of an item the one of that again.
*/
class Item_numbers
{
public:
  template <class Vertex_handle> Vertex_handle add_vertex(Vertex_handle v) {
    m_vertex_ids.give(v);
    return stamp(v);
  }
  template <class Cell_handle> Cell_handle add_cell(Cell_handle c) {
    m_cell_ids.give(c);
    return stamp(c);
  }

  // For so many cells, and their vertices, to be removed.
  void make_room(std::size_t vertices, std::size_t cells) {
    m_vertex_ids.make_room(vertices);
    m_cell_ids.make_room(cells);
  }
  // \pre there is room
  template <class Vertex_handle> void remove_vertex(Vertex_handle v) noexcept {
    m_vertex_ids.take_back(v);
  }
  template <class Cell_handle> void remove_cell(Cell_handle c) noexcept { m_cell_ids.take_back(c); }

  // Time stamps go on from where those of others are.
  void continue_time_stamps(const Item_numbers& other) { m_next_stamp = other.m_next_stamp; }

  std::size_t vertex_id_bound() const { return m_vertex_ids.bound(); }
  std::size_t cell_id_bound() const { return m_cell_ids.bound(); }

private:
  template <class Handle> Handle stamp(Handle item) {
    item->set_time_stamp(m_next_stamp++);
    return item;
  }

  std::size_t m_next_stamp = 0;
  Dense_ids m_vertex_ids, m_cell_ids;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_ITEM_NUMBERS_H
