// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_ADAPTIVE_ADVECTION_H
#define CGAL_INTERFACE_REMESHING_ADAPTIVE_ADVECTION_H

namespace CGAL::Deformable_simplicial_complexes {

/// \ingroup PkgInterfaceRemeshingRef
/// Default values that several packages use. Structs of options contain all other default values.
namespace defaults {

/// \ingroup PkgInterfaceRemeshingRef
/// Default values of `advect_adaptively()`, and of `Incompressible_fluid` for some parameters of
/// the same names. They are for long runs of flows that stretch an interface and can reverse this.
/// Flows that contract the interface cannot reverse it; angles and qualities are then those of
/// `Deformation_options`.
/// \tparam dimension dimension of the complex, 2 or 3
/// \tparam contracts whether the flow decreases the measure of the interface
template <int dimension, bool contracts = false> struct Adaptive_advection
{
  /// `interface_tolerance`, in mean edges of the initial interface: distance between edges and the
  /// smooth surface. Curves have few segments, so a smaller tolerance costs little in the plane.
  static constexpr double interface_tolerance = dimension == 2 ? .005 : .04;
  /// `adaptation_interval`, in time steps. A contraction shortens edges at junctions within one
  /// time step, so each time step adapts.
  static constexpr unsigned adaptation_interval = contracts ? 1 : 4;
  /// `feature_angle`, in degrees: below the angle of the edges of a cube, above the angle at the
  /// rim of a thin sheet. In the plane, a contraction rounds corners at once, so there are no
  /// features.
  static constexpr double feature_angle = contracts && dimension == 2 ? 180 : 85;
  /// `quality_threshold`: cells in thin sheets cannot have a high quality.
  static constexpr double quality_threshold = contracts ? .2 : .1;
  /// `minimum_angle`, in degrees: a flat cell can become thick again, unless the flow contracts the
  /// interface.
  static constexpr double minimum_angle = contracts ? 5 : .1;
  /// `minimum_facet_angle`, in degrees, for the same reason.
  static constexpr double minimum_facet_angle = contracts ? 5 : 0;
  /// `collapse_length` of edges off the interface, in mean edges of the initial interface: the mesh
  /// stays fine enough for the next time steps.
  static constexpr double collapse_length = 2;
};

} // namespace defaults
} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_ADAPTIVE_ADVECTION_H
