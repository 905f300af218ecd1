// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_CELL_SNAPSHOT_H
#define CGAL_INTERFACE_REMESHING_CELL_SNAPSHOT_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceRemeshingRef

The labels and the corners of all cells of a complex at some moment, for example when values of
cells were computed. Later, `changed_cells()` returns the cells whose values are out of date. It
takes the memory of a number for each cell, and of a point for each vertex.

\tparam Complex a deformable simplicial complex
*/
template <class Complex> class Cell_snapshot
{
public:
  using Cell_handle = typename Complex::Cell_handle; ///< a cell

  /// Stores the labels and the corners. n log n in the number of cells.
  explicit Cell_snapshot(const Complex& complex) : m_version(complex.version()) {
    for (auto v : complex.vertices())
      m_positions.emplace_back(v->time_stamp(), complex.position(v));
    for (auto c : complex.cells())
      m_labels.emplace_back(c->time_stamp(), c->subdomain_index());
  }

  /// Returns the cells that did not exist in the snapshot, had another label, or had a corner at
  /// another place, by increasing time stamp. n log n in the number of cells.
  /// \pre it is the same complex; it was not restored from a state
  std::vector<Cell_handle> changed_cells(const Complex& complex) const {
    std::vector<Cell_handle> result;
    if (complex.version() == m_version)
      return result;
    for (auto c : complex.cells()) {
      const auto* label = find(m_labels, c->time_stamp());
      bool is_same = label != nullptr && *label == c->subdomain_index();
      for (int i = 0; i < Complex::corners && is_same; ++i) {
        const auto* position = find(m_positions, c->vertex(i)->time_stamp());
        is_same = position != nullptr && *position == complex.position(c->vertex(i));
      }
      if (!is_same)
        result.push_back(c);
    }
    return result;
  }

private:
  template <class T> using Table = std::vector<std::pair<std::size_t, T>>; // by time stamp

  // Returns the entry with a time stamp; a null pointer if there is none.
  template <class T> static const T* find(const Table<T>& table, std::size_t time_stamp) {
    const auto place = std::lower_bound(table.begin(), table.end(), time_stamp,
                                        [](const std::pair<std::size_t, T>& entry,
                                           std::size_t stamp) { return entry.first < stamp; });
    return place != table.end() && place->first == time_stamp ? &place->second : nullptr;
  }

  std::uint64_t m_version;
  Table<typename Complex::Point> m_positions;
  Table<typename Complex::Label> m_labels;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_CELL_SNAPSHOT_H
