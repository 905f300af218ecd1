// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_FLOWS_COMPILED_2_H
#define CGAL_INTERFACE_FLOWS_COMPILED_2_H

/// \file
/// Declares the contents of the component `Compiled` for flows of interfaces in the plane, and
/// those of
/// `<CGAL/Deformable_simplicial_complexes/compiled_2.h>`. A source file that includes this header
/// uses the compiled code and does not instantiate these templates again.
/// \pre The program links with `Deformable_simplicial_complex::Compiled`.

#include <CGAL/Deformable_simplicial_complexes/compiled_2.h>
#include <CGAL/Interface_flows/Mean_curvature_flow.h>
#include <CGAL/Interface_flows/Normal_offset.h>
#include <CGAL/Interface_flows/advect_adaptively.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_remeshing/restore_volumes.h>

namespace CGAL::Deformable_simplicial_complexes {
#define CGAL_DSC_COMPILED_COMPLEX internal::Default_complex_2
#include <CGAL/Interface_flows/compiled_functions.h>
#undef CGAL_DSC_COMPILED_COMPLEX
} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_FLOWS_COMPILED_2_H
