// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_MESH_OPERATIONS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_MESH_OPERATIONS_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/internal/operations/Star_optimizer.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/degeneracy_removal.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/edge_flip_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/edge_removal_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/multi_face_removal_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/vertex_smoothing.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The operations of mesh improvement that depend on the dimension.
template <class Complex> struct Mesh_operations
{
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  static constexpr int d = Complex::dimension;

  // Proposes to replace `c` and cells around it by better ones. Stops at the first proposal for
  // which `accept()` returns true, and returns whether there is one.
  template <class Accept>
  static bool propose_reconnection(const Complex& complex, Cell_handle c,
                                   [[maybe_unused]] bool is_thorough, Cavity<Complex>& cavity,
                                   const Accept& accept) {
    if constexpr (d == 2) {
      for (int i = 0; i < 3; ++i)
        if (propose_edge_flip(complex, c, i, cavity) && accept())
          return true;
    } else {
      for (int i = 0; i < 4; ++i)
        if (propose_multi_face_removal(complex, c, i, cavity) && accept())
          return true;
      for (int i = 0; i < 4; ++i)
        for (int j = i + 1; j < 4; ++j)
          if (propose_edge_removal(complex, c, i, j, cavity) && accept())
            return true;
      for (int i = 0; is_thorough && i < 4; ++i)
        if (propose_multi_face_retriangulation(complex, c, i, cavity) && accept())
          return true;
    }
    return false;
  }

  // Proposes to replace a cell that is nearly flat, or has a nearly flat facet. The interface may
  // move.
  static bool propose_degenerate_cell_removal(const Complex& complex, Cell_handle c,
                                              [[maybe_unused]] double quality, double cosine,
                                              Cavity<Complex>& cavity) {
    if constexpr (d == 2) {
      return propose_degenerate_triangle_removal(complex, c, cosine, c->quality(), cavity);
    } else {
      if (propose_degenerate_tetrahedron_removal(complex, c, quality, cavity))
        return true;
      for (int i = 0; i < 4; ++i)
        if (propose_degenerate_facet_removal(complex, c, i, cosine, c->quality(), cavity))
          return true;
      return false;
    }
  }

  // Proposes the position that maximizes the worst quality of a star.
  static bool propose_optimal_position(const Complex& complex, Vertex_handle v,
                                       const std::vector<Cell_handle>& star,
                                       typename Complex::Point& target) {
    if constexpr (d == 2) {
      if (complex.is_boundary(v) || v->is_interface())
        return false;
      const auto to = Star_optimizer<Complex>(complex, complex.quality_measure(), v, star).run();
      target = to;
      return to != complex.position(v) && complex.is_positive_star(v, star, target);
    } else {
      return Deformable_simplicial_complexes::propose_optimal_position(complex, v, star, target);
    }
  }

  // Returns whether an edge lies on the interface.
  static bool is_interface_edge(const Complex& complex, Cell_handle c, int i, int j) {
    if constexpr (d == 2)
      return complex.is_interface(typename Complex::Facet(c, 3 - i - j));
    else
      return complex.is_interface(typename Complex::Edge(c, i, j));
  }
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_MESH_OPERATIONS_H
