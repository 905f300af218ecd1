// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_SIZE_FIELD_2_H
#define CGAL_CURVATURE_SIZE_FIELD_2_H

#include <CGAL/Deformable_simplicial_complex_2/internal/interface/Interface_bends_2.h>
#include <CGAL/Deformable_simplicial_complexes/Curvature_size_field.h>

namespace CGAL {

/// \ingroup PkgDeformableSimplicialComplex3Ref
/// Lengths of edges by the curvature of an interface in the plane.
using Curvature_size_field_2 = Curvature_size_field<2>;

} // namespace CGAL

#endif // CGAL_CURVATURE_SIZE_FIELD_2_H
