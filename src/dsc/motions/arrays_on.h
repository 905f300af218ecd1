// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_ARRAYS_ON_H
#define DSC_ARRAYS_ON_H

#include "input/labeled_tetrahedra.h"

#include <CGAL/Deformable_simplicial_complex_3.h>

namespace dsc {

/// Returns the arrays of a mesh on the vertices and cells of a complex that contains the same
/// regions, with other cells. A cell gets the content of the parts of the old cells of its label
/// inside it, and the integers of the old cell that it overlaps most. Cells outside the old ones
/// get 0. A vertex gets the values of the linear functions in the old cell around it, and the
/// integers of the nearest corner. Vertices outside get the values of a vertex near them.
Mesh_arrays arrays_on(const CGAL::Deformable_simplicial_complex_3<>& complex,
                      const Labeled_tetrahedra& mesh);

/// Returns the tetrahedra of a complex, with arrays by increasing time stamps.
Labeled_tetrahedra tetrahedra_of(const CGAL::Deformable_simplicial_complex_3<>& complex,
                                 const Mesh_arrays& arrays);

} // namespace dsc

#endif // DSC_ARRAYS_ON_H
