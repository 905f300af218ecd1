// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_INTERNAL_GRIDS_MERGED_CORNERS_H
#define CGAL_MESH_FILES_INTERNAL_GRIDS_MERGED_CORNERS_H

#include <CGAL/Mesh_support/internal/sets/equal_points.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The points of a file that repeats points, for example once for each tetrahedron. Equal corners of
// tetrahedra become one point, the first one of them. Equal points without tetrahedra become this
// point, too; others stay.
class Merged_corners
{
public:
  // Replaces the corners of the tetrahedra by the merged points.
  Merged_corners(const std::vector<std::array<double, 3>>& points,
                 std::vector<std::array<std::size_t, 4>>& tetrahedra)
      : m_new_index(points.size()), m_is_corner(points.size(), false) {
    for (const auto& tetrahedron : tetrahedra)
      for (const std::size_t v : tetrahedron)
        m_is_corner[v] = true;
    const std::vector<std::size_t> first = first_equal_points(points);
    std::vector<std::size_t> first_corner(points.size(), points.size());
    for (std::size_t i = points.size(); i-- > 0;)
      if (m_is_corner[i])
        first_corner[first[i]] = i;
    std::vector<std::size_t> kept(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::size_t corner = first_corner[first[i]];
      kept[i] = corner < points.size() ? corner : i;
      if (kept[i] == i) {
        m_new_index[i] = m_rows.size();
        m_rows.push_back(i);
      }
    }
    for (std::size_t i = 0; i < points.size(); ++i)
      m_new_index[i] = m_new_index[kept[i]];
    renumber(tetrahedra);
  }

  bool has_repeated_points() const { return m_rows.size() < m_new_index.size(); }

  // Returns, for each merged point, the point whose data it has.
  const std::vector<std::size_t>& rows() const { return m_rows; }

  // Replaces points by merged points.
  std::size_t& renumber(std::size_t& point) const { return point = m_new_index[point]; }
  template <class List> void renumber(List& points) const {
    for (auto& p : points)
      renumber(p);
  }

  // Returns the items of the merged points.
  template <class Item> std::vector<Item> selected(const std::vector<Item>& items) const {
    std::vector<Item> result;
    result.reserve(m_rows.size());
    for (const std::size_t row : m_rows)
      result.push_back(items[row]);
    return result;
  }

  // Returns whether equal corners have equal numbers: `components` for each point.
  template <class Number>
  bool agree(const std::vector<Number>& numbers, std::size_t components = 1) const {
    const auto are_equal = [](Number a, Number b) { return a == b || (a != a && b != b); };
    for (std::size_t i = 0; i < m_new_index.size(); ++i) {
      const auto row = numbers.begin() + std::ptrdiff_t(i * components);
      if (m_is_corner[i] &&
          !std::equal(row, row + std::ptrdiff_t(components),
                      numbers.begin() + std::ptrdiff_t(m_rows[m_new_index[i]] * components),
                      are_equal))
        return false;
    }
    return true;
  }

private:
  std::vector<std::size_t> m_new_index, m_rows;
  std::vector<bool> m_is_corner; // of a tetrahedron
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_FILES_INTERNAL_GRIDS_MERGED_CORNERS_H
