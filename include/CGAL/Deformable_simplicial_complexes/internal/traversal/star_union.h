// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TRAVERSAL_STAR_UNION_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TRAVERSAL_STAR_UNION_H

#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Marks.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/sort_by_time_stamp.h>
#include <CGAL/Mesh_support/For_each_index.h>

namespace CGAL::Deformable_simplicial_complexes {

// Returns the vertices of cells, each once, in the order in which they first occur. The infinite
// vertex is among them if one of the cells is infinite. Linear in the number of cells. Any number
// of threads can call the function at once.
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

// Returns the finite cells that are incident to vertices, each once, in the order of the stars.
// Linear in the size of the stars. Any number of threads can call the function at once.
//
// Precondition: The vertices are finite.
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

// Returns whether a pass over all cells of a complex is estimated to take less time than the stars
// of a number of vertices.
template <class Complex> bool are_many(const Complex& complex, std::size_t number_of_vertices) {
  static constexpr std::size_t many =
      8; // ratio of the costs of a star and of the cells of a vertex in a pass
  return number_of_vertices * many > complex.number_of_vertices();
}

// Returns the finite cells that are incident to vertices and for which a condition holds, each
// once, in an unspecified order that does not depend on the number of threads. Uses `stars_of()` or
// one pass over all cells, whichever is estimated to be faster. Any number of threads can call the
// function at once.
//
// complex,: vertices a complex, and finite vertices of it
// condition: function object; `condition(c)` can be called by several threads
// for_each_index: loop over indices, used for a pass over all cells
template <class Complex, class Condition>
std::vector<typename Complex::Cell_handle>
star_union_if(const Complex& complex, const std::vector<typename Complex::Vertex_handle>& vertices,
              const Condition& condition, const For_each_index& for_each_index) {
  using Cell_handle = typename Complex::Cell_handle;
  if (!are_many(complex, vertices.size())) {
    std::vector<Cell_handle> result = stars_of(complex, vertices);
    result.erase(
        std::remove_if(result.begin(), result.end(), [&](Cell_handle c) { return !condition(c); }),
        result.end());
    return result;
  }
  internal::Marks around = internal::vertex_marks(complex);
  for (auto v : vertices)
    around.add(v);
  const auto is_around = [&](Cell_handle c) {
    for (int i = 0; i < Complex::corners; ++i)
      if (around.has(c->vertex(i)))
        return true;
    return false;
  };
  return complex.finite_cells_if([&](Cell_handle c) { return condition(c) && is_around(c); },
                                 for_each_index);
}

// Returns the finite cells that are incident to vertices; see `star_union_if()`.
template <class Complex>
std::vector<typename Complex::Cell_handle>
star_union(const Complex& complex, const std::vector<typename Complex::Vertex_handle>& vertices,
           const For_each_index& for_each_index = For_each_index()) {
  return star_union_if(
      complex, vertices, [](typename Complex::Cell_handle) { return true; }, for_each_index);
}

// Returns the finite cells that are incident to vertices, each once, by increasing time stamp. Sums
// in this order are deterministic. Takes the time of `star_union()` and of a radix sort of the
// cells. Any number of threads can call the function at once.
//
// Precondition: The vertices are finite.
template <class Complex>
std::vector<typename Complex::Cell_handle>
sorted_star_union(const Complex& complex,
                  const std::vector<typename Complex::Vertex_handle>& vertices) {
  std::vector<typename Complex::Cell_handle> result = star_union(complex, vertices);
  internal::sort_by_time_stamp(result);
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TRAVERSAL_STAR_UNION_H
