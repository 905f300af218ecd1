// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_MESH_OPERATIONS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_MESH_OPERATIONS_H

#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Mesh_operations_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Mesh_operations_3.h>

#include <type_traits>

namespace CGAL::Deformable_simplicial_complexes::internal {

/*
The dimension-specific operations of mesh improvement:
- `propose_reconnection(complex, c, is_thorough, cavity, accept)`: proposes to replace `c` and cells
  around it by better ones; it returns the first proposal for which `accept()` returns true
- `propose_insertion(complex, c, cavity)`: proposes to insert a vertex into a cell
- `propose_degenerate_cell_removal(complex, c, quality, cosine, cavity)`: proposes to replace a cell
  that is nearly flat, or has a nearly flat facet; the interface may move
- `propose_optimal_position(complex, v, star, target)`: proposes the position that maximizes the
  worst quality of a star
- `is_interface_edge(complex, c, i, j)`: returns whether an edge lies on the interface
*/
template <class Complex>
using Mesh_operations = std::conditional_t<Complex::dimension == 2, Mesh_operations_2<Complex>,
                                           Mesh_operations_3<Complex>>;

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_MESH_OPERATIONS_H
