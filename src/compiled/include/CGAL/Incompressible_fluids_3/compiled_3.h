// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_COMPILED_3_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_COMPILED_3_H

/// \file
/// Declares what the component `Compiled` contains of fluids: `CGAL::Incompressible_fluid_3` in the
/// default complex, and what `<CGAL/Deformable_simplicial_complexes/compiled_3.h>` declares.
/// \pre The program links with `Deformable_simplicial_complex::Compiled`.

#include <CGAL/Deformable_simplicial_complexes/compiled_3.h>
#include <CGAL/Incompressible_fluid_3.h>

#ifndef CGAL_DSC_FLUID_INSTANTIATION // The component defines it where it instantiates the class.
#define CGAL_DSC_FLUID_INSTANTIATION extern
#endif

namespace CGAL {
CGAL_DSC_FLUID_INSTANTIATION template class Deformable_simplicial_complexes::Incompressible_fluid<
    Deformable_simplicial_complex_3<>>;
} // namespace CGAL

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_COMPILED_3_H
