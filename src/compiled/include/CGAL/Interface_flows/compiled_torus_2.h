// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_FLOWS_COMPILED_TORUS_2_H
#define CGAL_INTERFACE_FLOWS_COMPILED_TORUS_2_H

/// \file
/// Declares the contents of the component `Compiled` for a torus instead of a box: the complex, the
/// functions that change it, and flows of its interface. The declarations of
/// `<CGAL/Interface_flows/compiled_2.h>` are included. A source file that includes this header uses
/// the compiled code and does not instantiate these templates again.
/// \pre The program links with `Deformable_simplicial_complex::Compiled_tori`.

#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Interface_flows/compiled_2.h>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {
using Torus_complex_2 = Deformable_simplicial_complex_2<Epick, Default, Torus_domain<2>>;
}

#define CGAL_DSC_COMPILED_COMPLEX internal::Torus_complex_2
#include <CGAL/Deformable_simplicial_complexes/compiled_functions.h>
#include <CGAL/Interface_flows/compiled_functions.h>
#undef CGAL_DSC_COMPILED_COMPLEX
} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_FLOWS_COMPILED_TORUS_2_H
