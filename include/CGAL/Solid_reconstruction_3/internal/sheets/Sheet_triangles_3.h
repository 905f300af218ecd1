// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_SHEETS_SHEET_TRIANGLES_3_H
#define CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_SHEETS_SHEET_TRIANGLES_3_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/internal/sets/Disjoint_sets.h>

#include <array>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A triangle soup with the triangles at each vertex.
class Sheet_triangles_3
{
public:
  using Triangle = std::array<std::size_t, 3>;

  Sheet_triangles_3(std::size_t number_of_points, const std::vector<Triangle>& triangles)
      : m_stars(number_of_points) {
    for (const Triangle& t : triangles)
      add(t);
  }

  const std::vector<Triangle>& all() const { return m_triangles; }
  // Returns the triangles at a vertex.
  const std::vector<std::size_t>& star(std::size_t v) const { return m_stars[v]; }

  void add(const Triangle& t) {
    for (std::size_t v : t)
      m_stars[v].push_back(m_triangles.size());
    m_triangles.push_back(t);
  }

  // Orients the triangles of each component like the first one, except where this is impossible.
  void orient() {
    std::vector<char> is_oriented(m_triangles.size(), 0);
    std::vector<std::size_t> stack;
    for (std::size_t first = 0; first < m_triangles.size(); ++first)
      if (std::exchange(is_oriented[first], 1) == 0)
        for (stack = {first}; !stack.empty();) {
          Progress_scope::check();
          const Triangle t = m_triangles[stack.back()];
          stack.pop_back();
          for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t i : m_stars[t[k]]) {
              Triangle& other = m_triangles[i];
              const auto v = std::find(other.begin(), other.end(), t[k]);
              const auto w = std::find(other.begin(), other.end(), t[(k + 1) % 3]);
              if (w == other.end() || std::exchange(is_oriented[i], 1) != 0)
                continue;
              if ((w - v + 3) % 3 == 1)
                std::iter_swap(v, w);
              stack.push_back(i);
            }
        }
  }

  // Returns the vertices opposite to an edge in its triangles.
  std::vector<std::size_t> opposite(std::size_t v, std::size_t w) const {
    std::vector<std::size_t> result;
    for (std::size_t i : m_stars[v])
      for (std::size_t k = 0; k < 3; ++k) {
        const Triangle& t = m_triangles[i];
        if (t[k] != v && t[k] != w && (t[(k + 1) % 3] == w || t[(k + 2) % 3] == w))
          result.push_back(t[k]);
      }
    return result;
  }

  // Returns the edges of exactly one triangle, in its orientation.
  std::vector<std::pair<std::size_t, std::size_t>> boundary() const {
    std::vector<std::pair<std::size_t, std::size_t>> result;
    for (const Triangle& t : m_triangles) {
      Progress_scope::check();
      for (std::size_t k = 0; k < 3; ++k)
        if (opposite(t[k], t[(k + 1) % 3]).size() == 1)
          result.emplace_back(t[k], t[(k + 1) % 3]);
    }
    return result;
  }

  // Returns whether the triangles at a vertex form one fan, open or closed.
  bool is_manifold_at(std::size_t v) const {
    const std::vector<std::size_t>& star = m_stars[v];
    Disjoint_sets fans(star.size());
    for (std::size_t i = 0; i < star.size(); ++i)
      for (std::size_t w : m_triangles[star[i]]) {
        if (w == v)
          continue;
        if (opposite(v, w).size() > 2)
          return false;
        for (std::size_t j = 0; j < i; ++j) {
          const Triangle& t = m_triangles[star[j]];
          if (std::find(t.begin(), t.end(), w) != t.end())
            fans.join(i, j);
        }
      }
    for (std::size_t i = 1; i < star.size(); ++i)
      if (fans.find(i) != 0)
        return false;
    return true;
  }

private:
  std::vector<Triangle> m_triangles;
  std::vector<std::vector<std::size_t>> m_stars;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_SHEETS_SHEET_TRIANGLES_3_H
