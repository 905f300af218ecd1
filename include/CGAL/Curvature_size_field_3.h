// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_SIZE_FIELD_3_H
#define CGAL_CURVATURE_SIZE_FIELD_3_H

#include <CGAL/Deformable_simplicial_complex_3/internal/interface/interface_triangles_3.h>
#include <CGAL/Deformable_simplicial_complexes/Curvature_size_field.h>

namespace CGAL {

/// \ingroup PkgDeformableSimplicialComplex3Ref
/// Lengths of edges by the curvature of an interface in space.
using Curvature_size_field_3 = Curvature_size_field<3>;

} // namespace CGAL

#endif // CGAL_CURVATURE_SIZE_FIELD_3_H
