// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPONENTS_KEPT_COMPONENTS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPONENTS_KEPT_COMPONENTS_H

#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Marks.h>

#include <array>

// Tests for changes of connected components of labels after a change of a few cells. These tests
// visit nearby cells first. If a test does not confirm a connection, the caller searches farther
// away, or visits all cells.

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns whether two cells with the same label are connected. The search starts from both cells at
// the same time. It ends when the two searches meet, or when the smaller component is exhausted.
// Each visited cell reduces `budget`; the function returns false, too, when the budget is used up.
template <class Complex>
bool are_connected(const Complex& complex, typename Complex::Cell_handle a,
                   typename Complex::Cell_handle b, std::size_t& budget) {
  if (a == b)
    return true;
  std::array<std::vector<typename Complex::Cell_handle>, 2> reached;
  std::array<Marks, 2> marks = {cell_marks(complex), cell_marks(complex)};
  marks[0].add(a, reached[0]);
  marks[1].add(b, reached[1]);
  for (std::size_t k = 0; k < reached[0].size() && k < reached[1].size() && budget > 1; ++k) {
    budget -= 2;
    for (std::size_t side : {0, 1})
      for (int i = 0; i < Complex::corners; ++i) {
        const auto n = reached[side][k]->neighbor(i);
        if (n->subdomain_index() != a->subdomain_index() || complex.is_infinite(n))
          continue;
        if (marks[1 - side].has(n))
          return true;
        marks[side].add(n, reached[side]);
      }
  }
  return false;
}

// Returns whether cells with the same label are connected through cells that have a vertex `v` with
// `is_near(v)`, without the cell `avoided`.
template <class Complex, class IsNear>
bool are_connected_nearby(const Complex& complex,
                          const std::vector<typename Complex::Cell_handle>& cells,
                          const IsNear& is_near, typename Complex::Cell_handle avoided = {}) {
  using Cell_handle = typename Complex::Cell_handle;
  std::vector<Cell_handle> reached;
  Marks marks = cell_marks(complex);
  marks.add(cells.front(), reached);
  std::size_t connected = 0; // number of leading elements of `cells` that have been reached
  for (std::size_t k = 0; k < reached.size(); ++k) {
    while (connected < cells.size() && marks.has(cells[connected]))
      ++connected;
    if (connected == cells.size())
      return true;
    for (int i = 0; i < Complex::corners; ++i) {
      const Cell_handle n = reached[k]->neighbor(i);
      bool is_in_reach = false;
      for (int j = 0; j < Complex::corners && !is_in_reach; ++j)
        is_in_reach = is_near(n->vertex(j));
      if (is_in_reach && n != avoided && n->subdomain_index() == cells.front()->subdomain_index() &&
          !complex.is_infinite(n))
        marks.add(n, reached);
    }
  }
  return false;
}

// A partition of cells into connected groups of one label each.
template <class Complex> class Cell_groups
{
public:
  using Cell_handle = typename Complex::Cell_handle;
  static constexpr std::size_t none = std::size_t(-1);

  Cell_groups(const Complex& complex, const std::vector<Cell_handle>& cells)
      : m_complex(complex), m_cells(cells), m_groups(cells.size(), none) {
    std::sort(m_cells.begin(), m_cells.end());
    std::vector<std::size_t> front;
    for (std::size_t seed = 0; seed < m_cells.size(); ++seed) {
      if (m_groups[seed] != none || complex.is_infinite(m_cells[seed]))
        continue;
      m_groups[seed] = m_size;
      for (front.assign(1, seed); !front.empty();) {
        const Cell_handle c = m_cells[front.back()];
        front.pop_back();
        for (int i = 0; i < Complex::corners; ++i) {
          const std::size_t n = index_of(c->neighbor(i));
          if (n != none && m_groups[n] == none && are_connected(c, c->neighbor(i))) {
            m_groups[n] = m_size;
            front.push_back(n);
          }
        }
      }
      ++m_size;
    }
  }

  std::size_t size() const { return m_size; }
  const std::vector<Cell_handle>& cells() const { return m_cells; }
  bool has(Cell_handle c) const { return index_of(c) != none; }
  // Returns the group of a cell, or `none` if the cell is infinite.
  // \pre `has(c)`
  std::size_t group_of(Cell_handle c) const { return m_groups[index_of(c)]; }

  // Returns whether two adjacent cells are connected through their common facet.
  bool are_connected(Cell_handle a, Cell_handle b) const {
    return a->subdomain_index() == b->subdomain_index() && !m_complex.is_infinite(a) &&
           !m_complex.is_infinite(b);
  }

private:
  std::size_t index_of(Cell_handle c) const {
    const auto it = std::lower_bound(m_cells.begin(), m_cells.end(), c);
    return it != m_cells.end() && *it == c ? std::size_t(it - m_cells.begin()) : none;
  }

  const Complex& m_complex;
  std::vector<Cell_handle> m_cells; // sorted
  std::vector<std::size_t> m_groups;
  std::size_t m_size = 0;
};

// The connections between neighboring cells through cells that will be replaced.
template <class Complex> class Connections
{
public:
  using Cell_handle = typename Complex::Cell_handle;

  Connections(const Complex& complex, const std::vector<Cell_handle>& removed)
      : m_complex(complex) {
    const Cell_groups<Complex> groups(complex, removed);
    m_ends.resize(groups.size());
    for (Cell_handle c : groups.cells())
      for (int i = 0; i < Complex::corners; ++i)
        if (groups.are_connected(c, c->neighbor(i)) && !groups.has(c->neighbor(i)))
          m_ends[groups.group_of(c)].push_back(c->neighbor(i));
  }

  // Returns whether the new cells connect the same neighbors, and whether each new cell has the
  // component number of its neighbors.
  bool are_kept_by(const std::vector<Cell_handle>& created) const {
    const Cell_groups<Complex> groups(m_complex, created);
    std::vector<bool> has_end(groups.size(), false);
    std::vector<End> new_ends;
    for (Cell_handle c : created)
      for (int i = 0; i < Complex::corners; ++i) {
        const Cell_handle n = c->neighbor(i);
        if (!groups.are_connected(c, n))
          continue;
        if (n->component() != c->component())
          return false;
        if (!groups.has(n)) {
          has_end[groups.group_of(c)] = true;
          new_ends.emplace_back(n, groups.group_of(c));
        }
      }
    if (!std::all_of(has_end.begin(), has_end.end(), [](bool has) { return has; }))
      return false;
    std::sort(new_ends.begin(), new_ends.end());
    return std::all_of(m_ends.begin(), m_ends.end(), [&](const std::vector<Cell_handle>& ends) {
      return !ends.empty() &&
             (are_at_one_group(ends, new_ends) || are_connected_near(ends, created));
    });
  }

private:
  // A neighbor, and the group of new cells next to it.
  using End = std::pair<Cell_handle, std::size_t>;

  // Returns whether one group of new cells is next to all given neighbors. This is sufficient for
  // their connection, and is the usual case. `new_ends` is sorted.
  static bool are_at_one_group(const std::vector<Cell_handle>& ends,
                               const std::vector<End>& new_ends) {
    const auto group_of = [&](Cell_handle c) {
      const auto it = std::lower_bound(new_ends.begin(), new_ends.end(), End(c, 0));
      return it != new_ends.end() && it->first == c ? it->second : Cell_groups<Complex>::none;
    };
    const std::size_t group = group_of(ends.front());
    return group != Cell_groups<Complex>::none &&
           std::all_of(ends.begin(), ends.end(),
                       [&](Cell_handle c) { return group_of(c) == group; });
  }

  // Returns whether neighbors are connected through cells that share a vertex with the new cells.
  bool are_connected_near(const std::vector<Cell_handle>& ends,
                          const std::vector<Cell_handle>& created) const {
    std::vector<typename Complex::Vertex_handle> vertices;
    for (Cell_handle c : created)
      for (int i = 0; i < Complex::corners; ++i)
        if (!m_complex.is_infinite(c->vertex(i)))
          vertices.push_back(c->vertex(i));
    std::sort(vertices.begin(), vertices.end());
    return are_connected_nearby(m_complex, ends, [&](auto v) {
      return std::binary_search(vertices.begin(), vertices.end(), v);
    });
  }

  const Complex& m_complex;
  // for each group, the neighbors that it is connected with
  std::vector<std::vector<Cell_handle>> m_ends;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPONENTS_KEPT_COMPONENTS_H
