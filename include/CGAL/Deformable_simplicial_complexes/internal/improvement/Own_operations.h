// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_OWN_OPERATIONS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_OWN_OPERATIONS_H

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
template <class Complex, int dimension = Complex::dimension> struct Own_operations;

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_OWN_OPERATIONS_H
