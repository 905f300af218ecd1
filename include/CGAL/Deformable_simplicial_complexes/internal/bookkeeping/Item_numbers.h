// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BOOKKEEPING_ITEM_NUMBERS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BOOKKEEPING_ITEM_NUMBERS_H

#include <CGAL/Deformable_simplicial_complexes/simplex_bases.h>

#include <algorithm>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A generator of small ids. Ids that are taken back are given again. The items in use can be
// accessed by their ids.
template <class Handle> class Dense_ids
{
public:
  // Returns a bound that is greater than all ids in use.
  std::size_t bound() const { return m_items.size(); }

  // Returns the item with an id less than the bound, or `Handle()` if the id is not in use.
  Handle operator[](std::size_t id) const { return m_items[id]; }

  void give(Handle item) {
    if (m_free.empty()) {
      Simplex_access::set_id(item, std::uint32_t(m_items.size()));
      m_items.push_back(item);
    } else {
      Simplex_access::set_id(item, m_free.back());
      m_items[m_free.back()] = item;
      m_free.pop_back();
    }
  }

  // Allocates memory so that ids can be given to `given` items and taken back from `taken` items
  // without an allocation.
  void make_room(std::size_t given, std::size_t taken) {
    make_room_in(m_items, given);
    make_room_in(m_free, taken);
  }

  // Takes back the id of an item.
  // \pre Memory was allocated by `make_room()`.
  void take_back(Handle item) noexcept {
    m_items[item->id()] = Handle();
    m_free.push_back(item->id());
  }

private:
  template <class T> static void make_room_in(std::vector<T>& list, std::size_t number) {
    if (const std::size_t needed = list.size() + number; needed > list.capacity())
      list.reserve((std::max)(needed, 2 * list.capacity()));
  }

  std::vector<Handle> m_items; // by id
  std::vector<std::uint32_t> m_free;
};

/*
The numbers of the items of a complex. Each item has two numbers:
- a time stamp, in the order of creation; no two items ever have the same time stamp;
- an id, from a dense range, which is an index into arrays outside the complex.

Orders are defined by time stamps, because ids depend on previous changes of the complex. Time
stamps by CGAL are not used: CGAL 6 gives an item created in place of a deleted one the time stamp
of the deleted item.
*/
template <class Vertex_handle, class Cell_handle> class Item_numbers
{
public:
  Vertex_handle add_vertex(Vertex_handle v) {
    Simplex_access::join(*v);
    m_vertex_ids.give(v);
    return stamp(v);
  }
  Cell_handle add_cell(Cell_handle c) {
    Simplex_access::join(*c, *c);
    m_cell_ids.give(c);
    return stamp(c);
  }

  // Allocates memory so that vertices and cells can be added and as many can be removed.
  void make_room(std::size_t vertices, std::size_t added_cells, std::size_t removed_cells) {
    m_vertex_ids.make_room(vertices, vertices);
    m_cell_ids.make_room(added_cells, added_cells + removed_cells);
  }
  // Takes back the id of a vertex.
  // \pre Memory was allocated by `make_room()`.
  void remove_vertex(Vertex_handle v) noexcept { m_vertex_ids.take_back(v); }
  void remove_cell(Cell_handle c) noexcept { m_cell_ids.take_back(c); }

  // Returns the cell with an id less than the bound, or a null handle if there is none.
  Cell_handle cell(std::size_t id) const { return m_cell_ids[id]; }

  // Continues with the next time stamp of another complex.
  void continue_time_stamps(const Item_numbers& other) { m_next_stamp = other.m_next_stamp; }

  std::size_t vertex_id_bound() const { return m_vertex_ids.bound(); }
  std::size_t cell_id_bound() const { return m_cell_ids.bound(); }

private:
  template <class Handle> Handle stamp(Handle item) {
    item->set_time_stamp(m_next_stamp++);
    return item;
  }

  std::size_t m_next_stamp = 0;
  Dense_ids<Vertex_handle> m_vertex_ids;
  Dense_ids<Cell_handle> m_cell_ids;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BOOKKEEPING_ITEM_NUMBERS_H
