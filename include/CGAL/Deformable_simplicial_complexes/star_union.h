// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_STAR_UNION_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_STAR_UNION_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Marks.h>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

// The vertices of cells.
template <class Complex>
std::vector<typename Complex::Vertex_handle>
vertices_of(const Complex& complex, const std::vector<typename Complex::Cell_handle>& cells) {
  std::vector<typename Complex::Vertex_handle> result;
  internal::Marks seen = internal::vertex_marks(complex);
  for (auto c : cells)
    for (int i = 0; i < Complex::corners; ++i)
      seen.add(c->vertex(i), result);
  return result;
}

// The finite cells around vertices, each once, by their stars.
template <class Complex>
std::vector<typename Complex::Cell_handle>
stars_of(const Complex& complex, const std::vector<typename Complex::Vertex_handle>& vertices) {
  std::vector<typename Complex::Cell_handle> result, star;
  internal::Marks seen = internal::cell_marks(complex);
  for (auto v : vertices) {
    complex.star(v, star);
    for (auto c : star)
      if (!complex.is_infinite(c))
        seen.add(c, result);
  }
  return result;
}

// Whether one pass over all cells is cheaper than the stars of some vertices.
template <class Complex> bool are_many(const Complex& complex, std::size_t number_of_vertices) {
  static constexpr std::size_t many = 8; // a star costs about as much as 8 cells of a pass each
  return number_of_vertices * many > complex.number_of_vertices();
}

// The same in no particular order.
template <class Complex>
std::vector<typename Complex::Cell_handle>
star_union(const Complex& complex, const std::vector<typename Complex::Vertex_handle>& vertices) {
  if (!are_many(complex, vertices.size()))
    return stars_of(complex, vertices);
  internal::Marks around = internal::vertex_marks(complex);
  for (auto v : vertices)
    around.add(v);
  std::vector<typename Complex::Cell_handle> result;
  for (auto c : complex.finite_cells()) {
    bool is_around = false;
    for (int i = 0; i < Complex::corners && !is_around; ++i)
      is_around = around.has(c->vertex(i));
    if (is_around)
      result.push_back(c);
  }
  return result;
}

// The same by increasing time stamp, for sums that depend on the order.
template <class Complex>
std::vector<typename Complex::Cell_handle>
sorted_star_union(const Complex& complex,
                  const std::vector<typename Complex::Vertex_handle>& vertices) {
  using Cell_handle = typename Complex::Cell_handle;
  std::vector<std::pair<std::size_t, Cell_handle>> stamped;
  for (Cell_handle c : star_union(complex, vertices))
    stamped.emplace_back(c->time_stamp(), c);
  using Item = std::pair<std::size_t, Cell_handle>;
  boost::sort::spreadsort::integer_sort(
      stamped.begin(), stamped.end(),
      [](const Item& item, unsigned shift) { return item.first >> shift; },
      [](const Item& a, const Item& b) { return a.first < b.first; });
  std::vector<Cell_handle> result;
  result.reserve(stamped.size());
  for (const auto& item : stamped)
    result.push_back(item.second);
  return result;
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_STAR_UNION_H
