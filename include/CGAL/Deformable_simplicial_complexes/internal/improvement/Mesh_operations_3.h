// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_MESH_OPERATIONS_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_MESH_OPERATIONS_3_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/degeneracy_removal_3.h>
#include <CGAL/Deformable_simplicial_complexes/edge_removal_3.h>
#include <CGAL/Deformable_simplicial_complexes/multi_face_removal_3.h>
#include <CGAL/Deformable_simplicial_complexes/multi_face_retriangulation_3.h>
#include <CGAL/Deformable_simplicial_complexes/vertex_insertion.h>
#include <CGAL/Deformable_simplicial_complexes/vertex_optimization_3.h>

#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The operations of `Mesh_operations` for tetrahedra.
template <class Complex> struct Mesh_operations_3
{
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;

  template <class Accept>
  static bool propose_reconnection(const Complex& complex, Cell_handle c, bool is_thorough,
                                   Cavity<Complex>& cavity, const Accept& accept) {
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
    return false;
  }

  static bool propose_insertion(const Complex& complex, Cell_handle c, Cavity<Complex>& cavity) {
    return propose_vertex_insertion(complex, c, cavity);
  }

  static bool propose_degenerate_cell_removal(const Complex& complex, Cell_handle c, double quality,
                                              double cosine, Cavity<Complex>& cavity) {
    if (propose_degenerate_tetrahedron_removal(complex, c, quality, cavity))
      return true;
    for (int i = 0; i < 4; ++i)
      if (propose_degenerate_facet_removal(complex, c, i, cosine, c->quality(), cavity))
        return true;
    return false;
  }

  static bool propose_optimal_position(const Complex& complex, Vertex_handle v,
                                       const std::vector<Cell_handle>& star,
                                       typename Complex::Point& target) {
    return Deformable_simplicial_complexes::propose_optimal_position(complex, v, star, target);
  }

  static bool is_interface_edge(const Complex& complex, Cell_handle c, int i, int j) {
    return complex.is_interface(typename Complex::Edge(c, i, j));
  }
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_MESH_OPERATIONS_3_H
