// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_STAR_UNION_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_STAR_UNION_H

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Numbers vertices by their place in a list.
template <class Vertex_handle> void number_vertices(const std::vector<Vertex_handle>& vertices) {
  for (std::uint32_t i = 0; i < vertices.size(); ++i)
    vertices[i]->set_scratch_index(i);
}

// Whether v is in a list whose vertices are numbered by it.
template <class Vertex_handle>
bool is_numbered(Vertex_handle v, const std::vector<Vertex_handle>& vertices) {
  return v->scratch_index() < vertices.size() && vertices[v->scratch_index()] == v;
}

// The finite cells around numbered vertices, each once, in no particular order. Where many vertices
// are asked for, one pass over the cells is cheaper than their stars.
template <class Complex>
std::vector<typename Complex::Cell_handle>
star_union(const Complex& complex, const std::vector<typename Complex::Vertex_handle>& vertices) {
  using Cell_handle = typename Complex::Cell_handle;
  static constexpr std::size_t many = 8; // a star costs about as much as 8 cells of a pass each
  std::vector<Cell_handle> result;
  if (vertices.size() * many > complex.number_of_vertices()) {
    for (Cell_handle c : complex.triangulation().finite_cell_handles())
      if (is_numbered(c->vertex(0), vertices) || is_numbered(c->vertex(1), vertices) ||
          is_numbered(c->vertex(2), vertices) || is_numbered(c->vertex(3), vertices))
        result.push_back(c);
  } else {
    std::vector<Cell_handle> star;
    for (auto v : vertices) {
      complex.star(v, star);
      // A cell is taken at the first of its numbered vertices.
      for (Cell_handle c : star) {
        const auto is_earlier = [&](int i) {
          return is_numbered(c->vertex(i), vertices) &&
                 c->vertex(i)->scratch_index() < v->scratch_index();
        };
        if (!complex.is_infinite(c) && !is_earlier(0) && !is_earlier(1) && !is_earlier(2) &&
            !is_earlier(3))
          result.push_back(c);
      }
    }
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

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_STAR_UNION_H
