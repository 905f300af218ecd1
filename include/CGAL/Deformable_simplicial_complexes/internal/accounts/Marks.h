// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_ACCOUNTS_MARKS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_ACCOUNTS_MARKS_H

#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Adds cells to a list and marks them; takes the marks back in the end, whatever happens.
template <class Cell_handle> class Marks
{
public:
  // The list is empty, and outlives the marks.
  explicit Marks(std::vector<Cell_handle>& cells) : m_cells(cells) {}
  Marks(const Marks&) = delete;
  Marks& operator=(const Marks&) = delete;
  ~Marks() {
    for (Cell_handle c : m_cells)
      c->tds_data().clear();
  }

  static bool has(Cell_handle c) { return c->tds_data().is_in_conflict(); }

  // A cell that has no mark gets one and comes into the list.
  void add(Cell_handle c) {
    if (has(c))
      return;
    m_cells.push_back(c);
    c->tds_data().mark_in_conflict();
  }

private:
  std::vector<Cell_handle>& m_cells;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_ACCOUNTS_MARKS_H
