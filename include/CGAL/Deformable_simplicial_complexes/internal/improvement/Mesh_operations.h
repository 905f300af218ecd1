// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_MESH_OPERATIONS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_MESH_OPERATIONS_H

#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Mesh_operations_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Mesh_operations_3.h>

#include <type_traits>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

/*
What the improvement of a mesh does in one dimension only:

- `propose_reconnection(complex, c, is_thorough, cavity, accept)`: the first proposal of other cells
  instead of c and those around that makes them better and that `accept()` takes
- `propose_insertion(complex, c, cavity)`: a new vertex within a cell
- `propose_degenerate_cell_removal(complex, c, quality, cosine, cavity)`: other cells instead of one
  that is nearly flat, or has a facet that is; the interface may move
- `propose_optimal_position(complex, v, star, target)`: where the worst quality of a star is highest
- `is_interface_edge(complex, c, i, j)`
*/
template <class Complex>
using Mesh_operations = std::conditional_t<Complex::dimension == 2, Mesh_operations_2<Complex>,
                                           Mesh_operations_3<Complex>>;

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_MESH_OPERATIONS_H
