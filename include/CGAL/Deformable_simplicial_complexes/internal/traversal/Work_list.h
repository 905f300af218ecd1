// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TRAVERSAL_WORK_LIST_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TRAVERSAL_WORK_LIST_H

#include <CGAL/Mesh_support/For_each_index.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A list of cells to visit while the mesh changes; see Labeled_complex::is_alive().
template <class Cell_handle> class Work_list
{
public:
  struct Item
  {
    Cell_handle cell;
    std::size_t time_stamp;
  };

  void push(Cell_handle c) { m_items.push_back({c, c->time_stamp()}); }
  void clear() { m_items.clear(); }
  bool empty() const { return m_items.empty(); }

  // Sorts the cells by creation and removes repetitions.
  void sort() {
    std::sort(m_items.begin(), m_items.end(),
              [](const Item& a, const Item& b) { return a.time_stamp < b.time_stamp; });
    const auto same = [](const Item& a, const Item& b) { return a.time_stamp == b.time_stamp; };
    m_items.erase(std::unique(m_items.begin(), m_items.end(), same), m_items.end());
  }

  typename std::vector<Item>::const_iterator begin() const { return m_items.begin(); }
  typename std::vector<Item>::const_iterator end() const { return m_items.end(); }

private:
  std::vector<Item> m_items;
};

// Returns the finite cells for which a condition holds, sorted. `condition(c)` can be called by
// several threads.
template <class Complex, class Condition>
Work_list<typename Complex::Cell_handle> work_list_if(const Complex& complex,
                                                      const Condition& condition,
                                                      const For_each_index& for_each_index) {
  Work_list<typename Complex::Cell_handle> result;
  for (typename Complex::Cell_handle c : complex.finite_cells_if(condition, for_each_index))
    result.push(c);
  result.sort();
  return result;
}

template <class Complex>
void push_finite(const Complex& complex, const std::vector<typename Complex::Cell_handle>& from,
                 Work_list<typename Complex::Cell_handle>& cells) {
  for (typename Complex::Cell_handle c : from)
    if (!complex.is_infinite(c))
      cells.push(c);
}

// Calls work(c, touched) for the cells c in the order of their creation, then for the cells added
// to `touched`, and so on. Cells that were removed meanwhile are skipped.
template <class Complex, class Work>
void work_in_rounds(const Complex& complex, Work_list<typename Complex::Cell_handle> cells,
                    unsigned rounds, const Work& work) {
  Work_list<typename Complex::Cell_handle> touched;
  for (unsigned round = 0; round < rounds && !cells.empty(); ++round) {
    cells.sort();
    touched.clear();
    for (const auto& item : cells) {
      Progress_scope::check();
      if (complex.is_alive(item.cell, item.time_stamp))
        work(item.cell, touched);
    }
    std::swap(cells, touched);
  }
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TRAVERSAL_WORK_LIST_H
