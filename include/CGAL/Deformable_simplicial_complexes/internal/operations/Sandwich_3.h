// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_OPERATIONS_SANDWICH_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_OPERATIONS_SANDWICH_3_H

#include <array>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The facets that are sandwiched between two vertices a and b: each facet has a cell with a below
// it and a cell with b above it. The first facet determines a and b.
template <class Complex> class Sandwich_3
{
public:
  using Cell_handle = typename Complex::Cell_handle;
  using Vertex_handle = typename Complex::Vertex_handle;

  struct Sheet
  {
    Cell_handle below, above; // the cells at a facet
  };
  struct Directed_edge
  {
    Vertex_handle source, target; // the facet is on the left, seen from b
  };

  Sandwich_3(const Complex& complex, Cell_handle below, int i)
      : m_complex(complex), m_first{below, below->neighbor(i)}, m_a(below->vertex(i)),
        m_b(m_first.above->vertex(m_first.above->index(below))) {}

  Vertex_handle a() const { return m_a; }
  Vertex_handle b() const { return m_b; }
  const Sheet& first() const { return m_first; }

  std::array<Directed_edge, 3> edges_of_first() const {
    const auto v = m_complex.facet_vertices({m_first.below, m_first.below->index(m_a)});
    return {{{v[0], v[1]}, {v[1], v[2]}, {v[2], v[0]}}};
  }

  // Finds the sandwiched facet g on the other side of the edge e of f. It exists if the four cells
  // around e are the two cells of f and the two cells of g, all with the same label. `apex` becomes
  // the third vertex of g.
  bool find_neighbor(const Sheet& f, const Directed_edge& e, Sheet& g, Vertex_handle& apex) const {
    const auto opposite = [&](Cell_handle c, Vertex_handle tip) {
      return 6 - c->index(e.source) - c->index(e.target) - c->index(tip);
    };
    const int below = opposite(f.below, m_a), above = opposite(f.above, m_b);
    g = {f.below->neighbor(below), f.above->neighbor(above)};
    if (m_complex.is_infinite(g.below) || m_complex.is_infinite(g.above) ||
        g.below->label() != f.below->label() || g.above->label() != f.below->label())
      return false;
    const int below_tip = opposite(g.below, m_a);
    apex = g.below->vertex(below_tip);
    return apex != m_b && g.below->neighbor(g.below->index(m_a)) == g.above;
  }

private:
  const Complex& m_complex;
  Sheet m_first;
  Vertex_handle m_a, m_b;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_OPERATIONS_SANDWICH_3_H
