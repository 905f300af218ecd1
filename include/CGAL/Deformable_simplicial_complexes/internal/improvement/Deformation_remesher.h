// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_DEFORMATION_REMESHER_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_DEFORMATION_REMESHER_H

#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Deformation_remesher_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Deformation_remesher_3.h>

#include <type_traits>

namespace CGAL::Deformable_simplicial_complexes::internal {

/*
The remeshing of a deformation, composed of dimension-specific operations:
- `begin_pass(pass)`: prepares a pass; some vertices have not reached their destinations
- `is_bad(c)`: returns whether a cell should be improved
- `remove_obstacle(c, may_remove_facets, touched)`: removes a cell that keeps a vertex from its
  destination
- `remove_degenerating_facets(touched)`: removes interface facets that the pass made degenerate
- `improve(cells)`: improves the cells that the pass touched
- `exchange_neighbors(moved, log)`: after the passes, exchanges neighbors where interface edges
  between regions have become short
- `cells_with_small_angles()`, `remove_small_angles(relabel)`: find and remove small angles after
the passes
- `report()`, `number_of_relocated()`, `exchanges()`: results

Cells that an operation creates or changes are appended to `touched`.
*/
template <class Complex>
using Deformation_remesher =
    std::conditional_t<Complex::dimension == 2, Deformation_remesher_2<Complex>,
                       Deformation_remesher_3<Complex>>;

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_DEFORMATION_REMESHER_H
