// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IMPROVE_MESH_3_H
#define CGAL_IMPROVE_MESH_3_H

#include <CGAL/Deformable_simplicial_complex_3/internal/improvement/Own_operations_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/remeshing/Patch_improver_3.h>
#include <CGAL/Deformable_simplicial_complexes/improve_mesh.h>

#ifdef CGAL_DSC_EXTERN // see the component Compiled
#include <CGAL/Deformable_simplicial_complex_3.h>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {
CGAL_DSC_EXTERN template Improvement_report improve_whole_mesh(Default_complex_3&,
                                                               const Mesh_improvement_options&,
                                                               Any_visitor<Default_complex_3>&);
} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL
#endif

#endif // CGAL_IMPROVE_MESH_3_H
