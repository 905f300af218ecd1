// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORM_INTERFACE_3_H
#define CGAL_DEFORM_INTERFACE_3_H

#include <CGAL/Deformable_simplicial_complex_3/internal/improvement/Mesh_care_3.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>

#ifdef CGAL_DSC_EXTERN // see the component Compiled
#include <CGAL/Deformable_simplicial_complex_3.h>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {
CGAL_DSC_EXTERN template Deformation_report<Default_complex_3>
deform(Default_complex_3&, const std::vector<Default_complex_3::Vertex_handle>&,
       const std::vector<Default_complex_3::Point>&, const Deformation_options<Default_complex_3>&,
       unsigned, unsigned, Any_visitor<Default_complex_3>&, const std::function<bool(unsigned)>&);
} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL
#endif

#endif // CGAL_DEFORM_INTERFACE_3_H
