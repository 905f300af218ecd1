// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Complex_construction, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_COMPLEX_CONSTRUCTION_TETRAHEDRALIZATION_3_H
#define CGAL_COMPLEX_CONSTRUCTION_TETRAHEDRALIZATION_3_H

#include <CGAL/license/Complex_construction.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgComplexConstructionRef

The result of a `ConstrainedTetrahedralizer_3`: the input points, in their order, followed by added
points, and positively oriented tetrahedra of these points.
*/
struct Tetrahedralization_3
{
  std::vector<std::array<double, 3>> points;          ///< input points, followed by added points
  std::vector<std::array<std::size_t, 4>> tetrahedra; ///< indices into `points`
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_COMPLEX_CONSTRUCTION_TETRAHEDRALIZATION_3_H
