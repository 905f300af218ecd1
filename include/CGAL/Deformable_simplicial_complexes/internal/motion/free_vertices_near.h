// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_FREE_VERTICES_NEAR_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_FREE_VERTICES_NEAR_H

#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Marks.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/sort_by_time_stamp.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the free vertices near moving vertices, by increasing time stamp: the vertices within a
// number of layers of edges, or all free vertices if many vertices move. A vertex on the boundary
// of the domain is free if it can move within its sides and one of these sides has a moving vertex:
// a contact line moves the boundary vertices around it.
template <class Complex>
std::vector<typename Complex::Vertex_handle>
free_vertices_near(const Complex& complex,
                   const std::vector<typename Complex::Vertex_handle>& moving, unsigned layers) {
  using Vertex_handle = typename Complex::Vertex_handle;
  static constexpr std::size_t much = 16;
  std::vector<Vertex_handle> found;
  unsigned moving_sides = 0;
  for (Vertex_handle v : moving)
    moving_sides |= v->boundary_class();
  const auto is_free = [&](Vertex_handle v) {
    if (v->is_interface() || complex.is_infinite(v))
      return false;
    return !complex.is_boundary(v) ||
           ((v->boundary_class() & moving_sides) != 0 &&
            !Boundary_class::fixes_all(v->boundary_class(), Complex::dimension));
  };
  if (moving.size() * much > complex.number_of_vertices()) {
    for (Vertex_handle v : complex.finite_vertices())
      if (is_free(v))
        found.push_back(v);
  } else {
    std::vector<Vertex_handle> front = moving, next;
    std::vector<typename Complex::Cell_handle> star;
    Marks seen = vertex_marks(complex);
    for (unsigned layer = 0; layer < layers; ++layer) {
      next.clear();
      for (Vertex_handle v : front) {
        complex.star(v, star);
        for (auto c : star)
          for (int i = 0; i < Complex::corners; ++i)
            if (is_free(c->vertex(i)) && seen.add(c->vertex(i))) {
              found.push_back(c->vertex(i));
              next.push_back(c->vertex(i));
            }
      }
      front.swap(next);
    }
  }
  sort_by_time_stamp(found);
  return found;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_FREE_VERTICES_NEAR_H
