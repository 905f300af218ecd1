// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUID_2_H
#define CGAL_INCOMPRESSIBLE_FLUID_2_H

#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Incompressible_fluids_3/Incompressible_fluid.h>

namespace CGAL {

/// \ingroup PkgIncompressibleFluids3Ref
/// The incompressible flow of liquids in the plane, see
/// `Deformable_simplicial_complexes::Incompressible_fluid`.
/// \tparam Complex an instance of `Deformable_simplicial_complex_2`
/// \tparam Solver a model of `SaddlePointSolver`
template <class Complex, class Solver = Deformable_simplicial_complexes::Saddle_point_solver>
using Incompressible_fluid_2 =
    Deformable_simplicial_complexes::Incompressible_fluid<Complex, Solver>;

} // namespace CGAL

#endif // CGAL_INCOMPRESSIBLE_FLUID_2_H
