// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_FLOWS_COMPILED_TORUS_3_H
#define CGAL_INTERFACE_FLOWS_COMPILED_TORUS_3_H

/// \file
/// Declares the contents of the component `Compiled` for a torus instead of a box: the complex, the
/// functions that change it, and flows of its interface. The declarations of
/// `<CGAL/Interface_flows/compiled_3.h>` are included. A source file that includes this header uses
/// the compiled code and does not instantiate these templates again.
/// \pre The program links with `Deformable_simplicial_complex::Compiled_tori`.

#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Interface_flows/compiled_3.h>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {
using Torus_complex_3 =
    Deformable_simplicial_complex_3<Epick, Default, Volume_length_ratio_3, Torus_domain<3>>;
}

#define CGAL_DSC_COMPILED_COMPLEX internal::Torus_complex_3
#include <CGAL/Deformable_simplicial_complexes/compiled_functions.h>
#include <CGAL/Interface_flows/compiled_functions.h>
#undef CGAL_DSC_COMPILED_COMPLEX
} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_FLOWS_COMPILED_TORUS_3_H
