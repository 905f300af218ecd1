// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFAULT_PARAMETERS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFAULT_PARAMETERS_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

namespace CGAL::Deformable_simplicial_complexes {

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Default values of the named parameters that are numbers, with their units and reasons. A
/// parameter of several functions can have several default values. "The paper" is the one by
/// Misztal and B&aelig;rentzen, see \ref dsc_mb "[1]" in the user manual.
namespace defaults {

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Default values of `quality_threshold`, in [0, 1]: cells of lower quality are improved.
struct Quality_threshold
{
  /// Of functions that construct a complex. A new mesh is optimized once. The value is greater than
  /// `in_motion`, so the first deformations have few cells to improve.
  static constexpr double of_new_mesh = .3;
  /// Of `deform_interface()`, in each pass. The mesh must only permit the motion of the interface;
  /// a greater value costs time and remeshes more cells.
  static constexpr double in_motion = .2;
  /// Of `improve_interface()`, for cells that it changes: the same quality as after a deformation.
  static constexpr double beside_interface = in_motion;
  /// Of `improve_mesh()`. With a greater value, the function inserts more vertices.
  static constexpr double of_mesh = .25;
  /// Of `improve_mesh()` with `aggressive`.
  static constexpr double of_mesh_if_aggressive = .46;
};

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Default values of `minimum_facet_angle`, in degrees: facets of the interface with a smaller
/// angle are removed, in space.
struct Minimum_facet_angle
{
  /// Of `deform_interface()`. Each removal changes the interface, so only facets are removed that
  /// would soon block the motion.
  static constexpr double in_motion = 5;
  /// Of `improve_interface()`, whose purpose is better facets.
  static constexpr double of_interface = 15;
};

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Default value of `minimum_angle` of `deform_interface()`, in degrees. After the last pass, cells
/// with a smaller angle are removed if they moved and have a low quality: tetrahedra by their
/// dihedral angles, triangles by their angles.
inline constexpr double minimum_angle = 5;

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Default value of `relabeling_threshold`, in [0, 1]: cells of lower quality between two sheets of
/// the interface can change their label. The value of the paper.
inline constexpr double relabeling_threshold = .01;

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Default value of `maximum_number_of_passes` of `deform_interface()`. Most deformations end
/// earlier, because all vertices have arrived or passes make no progress.
inline constexpr unsigned maximum_number_of_passes = 20;

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Default value of `number_of_threads`.
inline constexpr unsigned number_of_threads = 1;

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Default value of `integration_tolerance`, in mean edges of the initial interface: bound on the
/// estimated error of each step of the adaptive integration of a path. It is far below the distance
/// between an edge and a curved interface.
inline constexpr double integration_tolerance = 1e-4;

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Default value of `largest_displacement`, in local edge lengths: longest displacement of a vertex
/// relative to its neighbors in one deformation. In a rotation, it is a turn by 29 degrees. The
/// straight paths of a deformation then deviate from the circle by less than a thirtieth of the
/// radius.
inline constexpr double largest_displacement = .5;

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Default value of `edge_per_thickness`: longest edge of the interface of a new complex, in
/// thicknesses. Cells of thin parts then have a quality above that at which they are relabeled.
inline constexpr double edge_per_thickness = 3;

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Default value of `most_new_facets`: their cells take about a second.
inline constexpr unsigned most_new_facets = 10000;

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Default values of `advect_adaptively()`, and of `Incompressible_fluid` for some parameters of
/// the same names. They are for long runs of flows that stretch an interface and can reverse this.
/// Flows that contract the interface cannot reverse it and have values of their own.
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
  static constexpr double quality_threshold = contracts ? Quality_threshold::in_motion : .1;
  /// `minimum_angle`, in degrees: a flat cell can become thick again, unless the flow contracts the
  /// interface.
  static constexpr double minimum_angle = contracts ? defaults::minimum_angle : .1;
  /// `minimum_facet_angle`, in degrees, for the same reason.
  static constexpr double minimum_facet_angle = contracts ? Minimum_facet_angle::in_motion : 0;
  /// `collapse_length` of edges off the interface, in mean edges of the initial interface: the mesh
  /// stays fine enough for the next time steps.
  static constexpr double collapse_length = 2;
};

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Default value of `implicitness`, in [0.5, 1]: the part of a time step of a fluid after which
/// forces are evaluated. The midpoint conserves energy.
inline constexpr double implicitness = .5;

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Default value of `volume_tolerance` of `restore_volumes()`, relative to the target volume.
inline constexpr double volume_tolerance = 1e-10;

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Default value of `split_length`, in units of the target edge length: longer edges off the
/// interface are split. The value of the paper.
inline constexpr double split_length = 4;

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Default value of `collapse_quality`, in [0, 1]: no collapse creates a cell of lower quality. The
/// value of the paper.
inline constexpr double collapse_quality = .25;

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Default value of `aggressiveness`, in [0, 1): a vertex moves along eigenvectors of its quadric
/// whose eigenvalues are at most this multiple of the largest one. The value of the paper.
inline constexpr double aggressiveness = .025;

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Default value of `swept_volume`, in cubes of the target edge length, in the plane in squares:
/// bound on the volume between the interface before and after one operation.
inline constexpr double swept_volume = .1;

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Default value of `flip_angle`, in degrees: edges of the interface are flipped if the normals of
/// their facets differ by less. The interface looks flat there.
inline constexpr double flip_angle = 5;

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Default value of `feature_angle` of `improve_interface()`, in degrees: edges of the interface
/// are sharp, and stay sharp, if the normals of their facets differ by more.
inline constexpr double feature_angle = 60;

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Default values of `remove_degeneracies()`. The values of the paper.
struct Degenerate
{
  /// `degenerate_quality`: tetrahedra of lower quality are removed.
  static constexpr double quality = .005;
  /// `degenerate_cosine`: facets, in the plane triangles, with an angle of larger cosine are
  /// removed.
  static constexpr double cosine = .999;
  /// `degenerate_length`: shorter edges are removed, in units of the sizing field or of the
  /// shortest edge of the initial interface.
  static constexpr double length = .5;
};

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Default value of `interface_split_length`, in units of the target edge length: longer edges of
/// the interface are split. The value of the paper.
inline constexpr double interface_split_length = 2;

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Default values of `interface_collapse_length`: shorter edges of the interface are collapsed.
struct Interface_collapse_length
{
  /// Of `control_detail()`, in units of the sizing field or of the shortest edge of the initial
  /// interface. The value of the paper.
  static constexpr double in_shortest_edges = .5;
  /// Of `improve_interface()`, in units of the sizing field or of the mean edge of the initial
  /// interface. The function keeps the shape, and also has flips that improve angles.
  static constexpr double in_target_lengths = .25;
};

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Default value of `fit_tolerance` of `reconstruct_point_set_3()`, in units of the spacing of the
/// points: bound on the root mean square distance between a facet and its points.
inline constexpr double fit_tolerance = .03;

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Default values of `number_of_iterations`.
struct Number_of_iterations
{
  /// Of functions that optimize the mesh, such as `improve_mesh()`: bound on the rounds. Rounds end
  /// earlier if there is nothing to improve.
  static constexpr unsigned over_mesh = 10;
  /// Of `improve_interface()`. Each round processes and smooths the whole interface again.
  static constexpr unsigned over_interface = 1;
  /// Of `reconstruct_point_set_3()`: bound on the steps. Long narrow tunnels take many steps.
  static constexpr unsigned of_reconstruction = 80;
  /// Of `restore_volumes()`: bound on the deformations. Before each deformation, Newton's method
  /// computes its destinations.
  static constexpr unsigned towards_volumes = 5;
};

} // namespace defaults
} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFAULT_PARAMETERS_H
