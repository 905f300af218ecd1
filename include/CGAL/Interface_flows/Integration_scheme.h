// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_FLOWS_INTEGRATION_SCHEME_H
#define CGAL_INTERFACE_FLOWS_INTEGRATION_SCHEME_H

namespace CGAL::Deformable_simplicial_complexes {

/// \ingroup PkgInterfaceFlowsRef
/// The method by which `advect_interface()` integrates velocities over a time step.
enum class Integration_scheme {
  euler,   ///< Euler method: order 1, one evaluation of the velocity (Algorithm 1 of the paper)
  rk2,     ///< midpoint rule: order 2, two evaluations
  rk4,     ///< classical Runge-Kutta method: order 4, four evaluations
  adaptive ///< method of Dormand and Prince: order 5, substeps follow from a tolerance
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_FLOWS_INTEGRATION_SCHEME_H
