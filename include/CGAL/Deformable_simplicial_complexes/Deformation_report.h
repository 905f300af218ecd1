// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORMATION_REPORT_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORMATION_REPORT_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Improvement_report.h>
#include <CGAL/Deformable_simplicial_complexes/Neighbor_exchange.h>
#include <CGAL/Deformable_simplicial_complexes/Topology_event.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef
Report of a deformation. It names everything that was not reached or was lost.
\tparam Complex a deformable simplicial complex
*/
template <class Complex> struct Deformation_report
{
  /// Vertex that did not reach its destination.
  struct Unfinished_vertex
  {
    typename Complex::Vertex_handle vertex; ///< vertex of the interface
    double distance;                        ///< length of the remaining displacement
  };

  /// Cell whose quality is below `Complex::quality_floor`.
  struct Flat_cell
  {
    typename Complex::Cell_handle cell; ///< a finite cell
    double quality;                     ///< by the measure of the complex
  };

  /// Change of a label: numbers of its components, and volumes in the coordinates of the complex.
  struct Label_change
  {
    typename Complex::Label label = 0; ///< label of the components
    std::size_t before = 0;            ///< number of components before
    std::size_t after = 0;             ///< number of components after
    /// components that merged into others; before + split + appeared = after + merged + vanished
    std::size_t merged = 0;
    std::size_t split = 0;    ///< components that separated from others
    std::size_t vanished = 0; ///< components of which no cell is left
    std::size_t appeared = 0; ///< components without a predecessor
    double volume_before = 0; ///< 0 if the label had no cell
    double volume_after = 0;  ///< 0 if the label has no cell any more
  };

  /// Wall-clock time of each phase, in seconds.
  struct Seconds
  {
    double extension = 0;    ///< computing the extension of the displacement
    double motion = 0;       ///< moving vertices, and finding facets that degenerate
    double relabeling = 0;   ///< relabeling flat cells
    double obstacles = 0;    ///< removing obstacles between vertices and their destinations
    double improvement = 0;  ///< improving cells of low quality
    double small_angles = 0; ///< removing small angles at the end
    double rest = 0;         ///< beginning and end of the deformation
  };

  bool complete = true;                      ///< whether `unfinished` is empty
  std::vector<Unfinished_vertex> unfinished; ///< by increasing time stamp
  /// all flat cells of the complex at the end, by increasing time stamp
  std::vector<Flat_cell> flat;
  /// number of vertices that a merge or a collapse removed, or took off the interface, before they
  /// arrived
  std::size_t vanished = 0;
  /// number of vertices with destinations outside the domain, a box; each was sent to the nearest
  /// point of the box
  std::size_t stopped_at_boundary = 0;
  unsigned passes = 0; ///< executions of the main loop of Algorithm 1
  /// whether the visitor ended the deformation: `go_further()` returned false
  bool stopped = false;
  /// \var split
  /// number of edges split
  /// \var collapsed
  /// number of edges collapsed, on the interface or off it
  /// \var flipped
  /// number of edges, sets of facets, and edges of the interface removed
  /// \var smoothed
  /// number of vertices smoothed
  /// \var inserted
  /// number of vertices inserted into cells
  std::size_t split = 0, collapsed = 0, flipped = 0, smoothed = 0, inserted = 0;
  /// number of vertices of the interface that were moved away from the positions that they had
  /// reached, to remove small angles; by a twentieth of the mean edge length there, by a quarter at
  /// most
  std::size_t relocated = 0;
  std::size_t relabeled = 0;        ///< number of cells that changed their label
  std::vector<Label_change> labels; ///< one for each label before or after, by increasing label
  std::vector<Topology_event<Complex>> events;       ///< by increasing pass
  std::vector<Neighbor_exchange<Complex>> exchanges; ///< in 2D only, found at the end
  /// wall-clock times, the only member that differs from run to run
  Seconds seconds;
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORMATION_REPORT_H
