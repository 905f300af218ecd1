// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_DEFORMATION_REMESHER_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_DEFORMATION_REMESHER_H

#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Deformation_remesher_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Deformation_remesher_3.h>

#include <type_traits>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

/*
What a deformation does to the mesh, made of the operations of one dimension:

- `begin_pass(for_each_index)`: some vertices have not arrived
- `is_bad(c)`: a cell is worth being improved
- `remove_obstacle(c, may_remove_facets, touched)`: a cell keeps a vertex from its destination
- `remove_degenerating_facets(touched)`: those of the interface that the pass made bad
- `improve(cells)`: cells that the pass touched
- `exchange_neighbors(moved, log)`: in the end, where walls between phases have become short
- `cells_with_small_angles()`, `keeps_small_angles(c)`, `remove_small_angles(relabel)`: in the end
- `report()`, `number_of_relocated()`, `exchanges()`

Cells that an operation makes or touches go into `touched`.
*/
template <class Complex>
using Deformation_remesher =
    std::conditional_t<Complex::dimension == 2, Deformation_remesher_2<Complex>,
                       Deformation_remesher_3<Complex>>;

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_DEFORMATION_REMESHER_H
