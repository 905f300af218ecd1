// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_INTERFACE_IMPROVEMENT_OPTIONS_H
#define CGAL_INTERFACE_REMESHING_INTERFACE_IMPROVEMENT_OPTIONS_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_energy.h>
#include <CGAL/Interface_remeshing/Edge_unit.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/parameter_values.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceRemeshingRef

Options of `improve_interface()`. The named parameters of that function have the same names. Lengths
are in units of the target edge length, angles in degrees. "The paper" is the one by
Misztal and B&aelig;rentzen \cgalCite{cgal:mb-taitd-12}.

\tparam Complex a deformable simplicial complex
*/
template <class Complex> struct Interface_improvement_options
{
  /// Number of repetitions of all operations.
  unsigned number_of_iterations = 1;
  /// Largest ratio of the eigenvalues of the quadric of a vertex for which it may move in a
  /// direction, see `propose_null_space_position()`, in [0, 1). With 0, vertices are not smoothed.
  /// The value of the paper.
  double aggressiveness = .025;
  /// Target edge length, a positive function of position in the coordinates of the complex, such as
  /// `Curvature_sizing_field`, evaluated at midpoints of edges. If empty, it is
  /// `dsc.mean_interface_edge()` everywhere.
  typename Edge_unit<Complex>::Sizing_field sizing_field;
  /// Longer edges of the interface are split, greater than 0. The value of the paper.
  double interface_split_length = 2;
  /// Shorter edges of the interface are collapsed, at least 0. The function keeps the shape, and
  /// also has flips that improve angles, so the value is less than that of `Detail_options`.
  double interface_collapse_length = .25;
  /// Bound on the volume between the interface before and after a collapse, or after a flip that
  /// removes a small angle, in cubes of the target edge length, in the plane in squares; at least
  /// 0.
  double swept_volume = .1;
  /// An edge that does not fulfill the Delaunay criterion is flipped if the normals of its facets
  /// differ by less, in [0, 90]: the interface looks flat there. The worst cell around must improve
  /// or stay above the threshold. In space only. The value of the paper.
  double flip_angle = 5;
  /// Edges are features if the normals of their facets differ by more, in [0, 180]. They are never
  /// flipped, and their vertices move and collapse only along feature lines that bend by a smaller
  /// angle. In the plane, vertices where the edges differ by a larger angle are corners.
  double feature_angle = 60;
  /// An edge of a facet with a smaller angle is flipped or collapsed, whichever changes the shape
  /// less, in [0, 30]; in space only.
  double minimum_facet_angle = 15;
  /// Changed cells of lower quality are improved, in [0, 1].
  double quality_threshold = .2;
  /// Whether new vertices are placed on a smooth surface or curve interpolated from the neighbors
  /// of the edge, instead of on the edge, where the interface is smooth.
  bool curved_splits = false;
  /// Whether vertices where more than three phases meet are split into two junctions if this
  /// decreases the energy, see `propose_junction_split()`; in the plane only.
  bool split_junctions = false;
  /// The energy that splits of junctions decrease. Energy densities have no effect. The default is
  /// the length of the interface.
  Interface_energy interface_energy;
  /// Visitor of the changes; it must outlive the call. None if null.
  Deformation_visitor<Complex>* visitor = nullptr;

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

#endif // CGAL_INTERFACE_REMESHING_INTERFACE_IMPROVEMENT_OPTIONS_H
