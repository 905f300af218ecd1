// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERFACE_IMPROVEMENT_OPTIONS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERFACE_IMPROVEMENT_OPTIONS_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Any_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Edge_unit.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_energy.h>
#include <CGAL/Deformable_simplicial_complexes/default_parameters.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/parameter_values.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Options of `improve_interface()`. The named parameters of that function have the same names, and
their documentation describes the effects. Lengths are in units of the target edge length, angles in
degrees.

\tparam Complex a deformable simplicial complex
*/
template <class Complex> struct Interface_improvement_options
{
  /// Number of repetitions of all operations.
  unsigned number_of_iterations = defaults::Number_of_iterations::over_interface;
  /// Bound on the relative eigenvalues of directions of smoothing, in [0, 1). With 0, vertices are
  /// not smoothed.
  double aggressiveness = defaults::aggressiveness;
  /// Target edge length at a point. If empty, it is the mean edge of the initial interface.
  typename Edge_unit<Complex>::Sizing_field sizing_field;
  /// Longer edges of the interface are split, greater than 0.
  double interface_split_length = defaults::interface_split_length;
  /// Shorter edges of the interface are collapsed, at least 0.
  double interface_collapse_length = defaults::Interface_collapse_length::in_target_lengths;
  /// Bound on the volume that an operation sweeps, in cubes of the target edge length, in the plane
  /// in squares; at least 0.
  double swept_volume = defaults::swept_volume;
  /// Edges can be flipped if the normals of their facets differ by less, in [0, 90].
  double flip_angle = defaults::flip_angle;
  /// Edges are sharp if the normals of their facets differ by more, in [0, 180].
  double feature_angle = defaults::feature_angle;
  /// Facets with a smaller angle are removed, in [0, 30].
  double minimum_facet_angle = defaults::Minimum_facet_angle::of_interface;
  /// Changed cells of lower quality are improved, in [0, 1].
  double quality_threshold = defaults::Quality_threshold::beside_interface;
  /// Whether new vertices are placed on the smooth surface that the facets suggest.
  bool curved_splits = false;
  /// Whether junctions of more than three phases are split, in the plane.
  bool split_junctions = false;
  /// The energy that splits of junctions decrease. Energy densities have no effect. The default is
  /// the length of the interface.
  Interface_energy interface_energy;
  /// Visitor of the changes, such as a `Visitor_adaptor`; it must outlive the call. None if null.
  Any_visitor<Complex>* visitor = nullptr;

  /// Throws an exception unless all values are in their ranges.
  /// \throws Error if a value is out of its range
  void check() const {
    if (!(aggressiveness >= 0 && aggressiveness < 1))
      throw Error("the aggressiveness is out of range: use at least 0 and less than 1");
    if (!(interface_split_length > 0))
      throw Error("the length of edges to be split is out of range: use more than 0");
    if (!(interface_collapse_length >= 0))
      throw Error("the length of edges to be collapsed is out of range: use 0 or more");
    if (!(swept_volume >= 0))
      throw Error("the bound on the swept volume is out of range: use 0 or more");
    require_angle(flip_angle, 90, "flip angle");
    require_angle(feature_angle, 180, "feature angle");
    require_angle(minimum_facet_angle, 30, "minimum facet angle");
    require_quality(quality_threshold);
  }
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERFACE_IMPROVEMENT_OPTIONS_H
