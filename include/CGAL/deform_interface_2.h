// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORM_INTERFACE_2_H
#define CGAL_DEFORM_INTERFACE_2_H

#include <CGAL/Deformable_simplicial_complex_2/internal/improvement/Mesh_care_2.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>

#ifdef CGAL_DSC_EXTERN // see the component Compiled
#include <CGAL/Deformable_simplicial_complex_2.h>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {
CGAL_DSC_EXTERN template Deformation_report<Default_complex_2>
deform(Default_complex_2&, const std::vector<Default_complex_2::Vertex_handle>&,
       const std::vector<Default_complex_2::Point>&, const Deformation_options<Default_complex_2>&,
       unsigned, unsigned, Any_visitor<Default_complex_2>&, const std::function<bool(unsigned)>&);
} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL
#endif

#endif // CGAL_DEFORM_INTERFACE_2_H
