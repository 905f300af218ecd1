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

namespace CGAL {
namespace Deformable_simplicial_complexes {

// The default values of named parameters that are numbers, with their units and reasons; where
// several functions take a parameter, why they differ.

namespace defaults {

// quality_threshold: cells of lower quality are improved.
struct Quality_threshold
{
  // Once for each mesh, and above the others, so that the steps that follow begin with few cells to
  // improve.
  static constexpr double of_new_mesh = .3;
  // In each step: the mesh must let the interface move; more of it would be remeshed for nothing.
  static constexpr double in_motion = .2;
  // Of the cells that a change of the interface made bad: what is done between steps leaves the
  // mesh as motion does.
  static constexpr double beside_interface = in_motion;
  // On request, not in each step. From here on, vertices have to be inserted.
  static constexpr double of_mesh = .25;
  // With minutes instead of seconds; few meshes get farther.
  static constexpr double of_mesh_if_aggressive = .46;
};

// minimum_facet_angle: facets of the interface with a smaller angle are removed, in degrees.
struct Minimum_facet_angle
{
  // Each removal changes the interface, which nobody has asked for: only what would soon be in the
  // way of the motion.
  static constexpr double in_motion = 5;
  // That the triangles become better is what improve_interface() is called for.
  static constexpr double of_interface = 15;
};

// minimum_angle: tetrahedra with a smaller dihedral angle in the end are removed, in the plane
// triangles with a smaller angle, in degrees. Of those that flows leave, few have any; these would
// stay.
inline constexpr double minimum_angle = 5;

// relabeling_threshold: trapped cells below this quality take another label; the paper's.
inline constexpr double relabeling_threshold = .01;

// maximum_number_of_passes: nearly all motions end after less than ten.
inline constexpr unsigned maximum_number_of_passes = 20;

// number_of_threads
inline constexpr unsigned number_of_threads = 1;

// integration_tolerance: how far a path may end from where it should, in mean edges of the
// interface; far below what a straight edge leaves of a curve.
inline constexpr double integration_tolerance = 1e-4;

// What advect_adaptively() asks for: in long runs of flows that stretch an interface and may bring
// it back, or of flows that contract it and bring nothing back.
template <int dimension, bool contracts = false> struct Adaptive_advection
{
  // interface_tolerance: of the distance between edges and the smooth surface, in mean edges of the
  // interface: at which the volume of a sheet of a few triangles' thickness stays within 0.02 %.
  // Curves have few segments, which may be ten times as exact for nothing.
  static constexpr double interface_tolerance = dimension == 2 ? .005 : .04;
  // adaptation_interval: in steps; the cost of one is then about that of motion. Contraction
  // shortens edges at junctions within a step.
  static constexpr unsigned adaptation_interval = contracts ? 1 : 4;
  // feature_angle: below a cube, above the rims of thin sheets, in degrees. Contraction rounds
  // corners of curves at once: they are refined.
  static constexpr double feature_angle = contracts && dimension == 2 ? 180 : 85;
  // quality_threshold: thin sheets leave no room for more.
  static constexpr double quality_threshold = contracts ? Quality_threshold::in_motion : .1;
  // minimum_angle and minimum_facet_angle: what is pressed flat may become thick again, in degrees,
  // unless the flow contracts.
  static constexpr double minimum_angle = contracts ? defaults::minimum_angle : .1;
  static constexpr double minimum_facet_angle = contracts ? Minimum_facet_angle::in_motion : 0;
  // collapse_length: of edges off the interface, in mean edges of the interface: the mesh stays as
  // fine as a step or two need.
  static constexpr double collapse_length = 2;
};

// implicitness: when in a step of a fluid forces are taken, as part of the step: half-way, which
// keeps energy.
inline constexpr double implicitness = .5;

// volume_tolerance: of the volume that is wanted; what Newton's method reaches in two steps or
// three.
inline constexpr double volume_tolerance = 1e-10;

// split_length: longer edges off the interface are split, in units of the wanted length; the
// paper's.
inline constexpr double split_length = 4;

// collapse_quality: the least quality of a cell that a collapse may make; the paper's.
inline constexpr double collapse_quality = .25;

// aggressiveness: up to which ratio of the eigenvalues of a vertex' quadric it may move in their
// direction; the paper's.
inline constexpr double aggressiveness = .025;

// swept_volume: what an operation on the interface may add to a phase, in cubes of the wanted
// length.
inline constexpr double swept_volume = .1;

// flip_angle: up to which dihedral angle edges of the interface are flipped, in degrees: what is
// flat for the eye.
inline constexpr double flip_angle = 5;

// feature_angle: edges of the interface with a larger dihedral angle are kept, in degrees.
inline constexpr double feature_angle = 60;

// What remove_degeneracies() removes; the paper's: degenerate_quality of tetrahedra,
// degenerate_cosine of the smallest angle of facets (2.6 degrees), degenerate_length of edges, in
// units of the shortest of the input.
struct Degenerate
{
  static constexpr double quality = .005;
  static constexpr double cosine = .999;
  static constexpr double length = .5;
};

// interface_split_length: longer edges of the interface are split, in units of the wanted length;
// the paper's.
inline constexpr double interface_split_length = 2;

// interface_collapse_length: shorter edges of the interface are collapsed.
struct Interface_collapse_length
{
  static constexpr double in_shortest_edges = .5; // of the input: the paper's, for control_detail()
  // In units of the wanted length, which is the mean one of the input if none is given:
  // improve_interface() is to keep the shape, and has flips for the sake of angles.
  static constexpr double in_wanted_lengths = .25;
};

// fit_tolerance: of the root of the mean square of the distances of points from a facet, in
// spacings of the points: what is flat or smooth is met closer than that, so that all of a surface
// is within a fiftieth.
inline constexpr double fit_tolerance = .03;

// number_of_iterations: bounds on rounds.
struct Number_of_iterations
{
  // Rounds end by themselves where nothing is left to do, mostly before.
  static constexpr unsigned over_mesh = 10;
  // Each goes over the whole interface again and smooths it a little more.
  static constexpr unsigned over_interface = 1;
  // Steps of a reconstruction: most end after 30; long narrow tunnels take one for each width.
  static constexpr unsigned of_reconstruction = 80;
  // Steps towards volumes, each with several steps of Newton's method.
  static constexpr unsigned towards_volumes = 5;
};

} // namespace defaults
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFAULT_PARAMETERS_H
