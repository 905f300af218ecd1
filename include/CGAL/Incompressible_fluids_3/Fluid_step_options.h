// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_FLUID_STEP_OPTIONS_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_FLUID_STEP_OPTIONS_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_options.h>
#include <CGAL/Interface_remeshing/Adaptive_advection.h>
#include <CGAL/Mesh_support/Error.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgIncompressibleFluids3Ref

Options of the time steps of `Incompressible_fluid`. The named parameters of
`Incompressible_fluid::advance()` have the same names.

\tparam Complex an instance of `Deformable_simplicial_complex_2` or
        `Deformable_simplicial_complex_3`
*/
template <class Complex> struct Fluid_step_options
{
  /// Options of the deformations. The fluid has its own flow and visitor, so these two are not
  /// used.
  Deformation_options<Complex> deformation;
  /// The time in the step at which forces act, in steps, in [0.5, 1]. With 0.5, the step is the
  /// implicit midpoint rule, which preserves energy. With 1, it is the backward Euler method, which
  /// damps oscillations that are faster than the step. In the four steps after a change of
  /// topology, the value is at least 0.6.
  double implicitness = .5;
  /// Largest distance of an edge of the interface to a smooth surface, in mean edges of the initial
  /// interface, at least 0. The interface is remeshed as in `advect_adaptively()` if too many edges
  /// are too long or too short. With 0, the interface is not remeshed before steps.
  double interface_tolerance =
      defaults::Adaptive_advection<Complex::dimension>::interface_tolerance;
  /// Number of steps between two adaptations of the mesh. The first adaptation precedes the first
  /// step. With 0, the mesh is never adapted before steps. The motion can still change it.
  unsigned adaptation_interval =
      defaults::Adaptive_advection<Complex::dimension>::adaptation_interval;

  /// Throws an exception unless all values are in their ranges.
  /// \throws Error if a value is out of its range
  void check() const {
    deformation.check();
    if (!(implicitness >= .5 && implicitness <= 1))
      throw Error("the implicitness is out of range: use 0.5 to 1");
    if (!(interface_tolerance >= 0))
      throw Error("the tolerance of the interface is out of range: use 0 or more");
  }
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_FLUID_STEP_OPTIONS_H
