// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PARAMETERS_DEFAULT_PARAMETERS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PARAMETERS_DEFAULT_PARAMETERS_H

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// The default values of those named parameters that several functions take, and why they differ.
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

// number_of_iterations: bounds on rounds.
struct Number_of_iterations
{
  // Rounds end by themselves where nothing is left to do, mostly before.
  static constexpr unsigned over_mesh = 10;
  // Each goes over the whole interface again and smooths it a little more.
  static constexpr unsigned over_interface = 1;
};

} // namespace defaults

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PARAMETERS_DEFAULT_PARAMETERS_H
