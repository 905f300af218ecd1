// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IMPROVE_INTERFACE_3_H
#define CGAL_IMPROVE_INTERFACE_3_H

#include <CGAL/Deformable_simplicial_complex_3/internal/remeshing/Interface_improver_3.h>
#include <CGAL/Deformable_simplicial_complexes/improve_interface.h>

#ifdef CGAL_DSC_EXTERN // see the component Compiled
#include <CGAL/Deformable_simplicial_complex_3.h>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {
CGAL_DSC_EXTERN template Improvement_report
remesh_interface(Default_complex_3&, const Interface_thresholds&,
                 const Edge_unit<Default_complex_3>&, unsigned, Any_visitor<Default_complex_3>&);
} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL
#endif

#endif // CGAL_IMPROVE_INTERFACE_3_H
