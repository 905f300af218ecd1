// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_FLOWS_INTEGRATION_SCHEME_H
#define CGAL_INTERFACE_FLOWS_INTEGRATION_SCHEME_H

namespace CGAL {
namespace Deformable_simplicial_complexes {

/// \ingroup PkgInterfaceFlowsRef
/// How `advect_interface()` gets destinations from velocities.
enum class Integration_scheme {
  euler,   ///< first order, one evaluation of the velocity: the paper's Algorithm 1
  rk2,     ///< second order, the midpoint rule, two evaluations
  rk4,     ///< fourth order, the classical rule of Runge and Kutta, four evaluations
  adaptive ///< fifth order, the rule of Dormand and Prince in as many steps as a tolerance asks for
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INTERFACE_FLOWS_INTEGRATION_SCHEME_H
