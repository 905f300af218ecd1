// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_COMPILED_3_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_COMPILED_3_H

/// \file
/// Declares the contents of the component `Compiled` for fluids: `CGAL::Incompressible_fluid_3`
/// with the default complex, and the declarations of
/// `<CGAL/Deformable_simplicial_complexes/compiled_3.h>`. A source file that includes this header
/// uses the compiled code and does not instantiate these templates again.
/// \pre The program links with `Deformable_simplicial_complex::Compiled_fluids`.

#include <CGAL/Deformable_simplicial_complexes/compiled_3.h>
#include <CGAL/Incompressible_fluid_3.h>

namespace CGAL {
CGAL_DSC_INSTANTIATION template class Deformable_simplicial_complexes::Incompressible_fluid<
    Deformable_simplicial_complex_3<>>;
} // namespace CGAL

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_COMPILED_3_H
