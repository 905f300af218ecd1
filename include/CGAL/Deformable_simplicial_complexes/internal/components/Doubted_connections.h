// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPONENTS_DOUBTED_CONNECTIONS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPONENTS_DOUBTED_CONNECTIONS_H

#include <CGAL/Deformable_simplicial_complexes/internal/components/kept_components.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Groups of cells that relabeling may have disconnected; each group should be connected. Cells that
// have been cut off are often relabeled next, so the connections are checked only at the end. No
// cell may be replaced in the meantime.
template <class Cell_handle> class Doubted_connections
{
public:
  bool empty() const { return m_number_of_groups == 0; }

  // Returns the number of cells, each counted once for every group that contains it.
  std::size_t size() const { return m_doubts.size(); }

  void clear() {
    m_doubts.clear();
    m_number_of_groups = 0;
  }

  // Adds a group. Nothing changes if memory is exhausted.
  void add_group(const std::vector<Cell_handle>& cells) {
    m_doubts.reserve(m_doubts.size() + cells.size());
    for (Cell_handle c : cells)
      m_doubts.push_back({m_number_of_groups, c});
    ++m_number_of_groups;
  }

  // Returns whether a group contains a cell.
  bool has(Cell_handle c) const {
    return std::any_of(m_doubts.begin(), m_doubts.end(),
                       [&](const Doubt& doubt) { return doubt.cell == c; });
  }

  // Removes a cell that gets another label from all groups. Its neighbors that keep the label
  // replace it in each group. If there is no such neighbor, the groups of the cell are joined: each
  // group had to be connected with the cell, so the groups had to be connected with each other, and
  // no other cell states this. Returns whether the group still contains cells; if not, the
  // component has vanished.
  bool replace(Cell_handle c, const std::vector<Cell_handle>& left) {
    if (left.empty())
      join_groups_of(c);
    std::vector<Doubt> doubts;
    std::size_t group = 0;
    for (const Doubt& doubt : m_doubts)
      if (doubt.cell != c) {
        doubts.push_back(doubt);
      } else {
        group = doubt.group;
        for (Cell_handle n : left)
          doubts.push_back({doubt.group, n});
      }
    m_doubts.swap(doubts);
    return std::any_of(m_doubts.begin(), m_doubts.end(),
                       [&](const Doubt& doubt) { return doubt.group == group; });
  }

  // Returns whether each group is connected. Returns false, too, if the search exceeds its budget,
  // which is the cost of a traversal of all cells.
  template <class Complex> bool are_dispelled(const Complex& complex) const {
    std::vector<Cell_handle> first(m_number_of_groups);
    std::size_t budget = complex.cell_id_bound();
    for (const Doubt& doubt : m_doubts) {
      Cell_handle& c = first[doubt.group];
      if (c == Cell_handle())
        c = doubt.cell;
      else if (!are_connected(complex, c, doubt.cell, budget))
        return false;
    }
    return true;
  }

private:
  struct Doubt
  {
    std::size_t group;
    Cell_handle cell;
  };

  void join_groups_of(Cell_handle c) {
    std::vector<bool> is_joined(m_number_of_groups, false);
    std::size_t one = m_number_of_groups;
    for (const Doubt& doubt : m_doubts)
      if (doubt.cell == c) {
        is_joined[doubt.group] = true;
        one = (std::min)(one, doubt.group);
      }
    for (Doubt& doubt : m_doubts)
      if (is_joined[doubt.group])
        doubt.group = one;
  }

  std::vector<Doubt> m_doubts;
  std::size_t m_number_of_groups = 0;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPONENTS_DOUBTED_CONNECTIONS_H
