// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORMATION_REPORT_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORMATION_REPORT_H

#include <CGAL/Deformable_simplicial_complexes/Improvement_report.h>
#include <CGAL/Deformable_simplicial_complexes/Neighbor_exchange.h>
#include <CGAL/Deformable_simplicial_complexes/Topology_event.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef
What a deformation did: nothing is silently lost.
\tparam Complex an instance of `Deformable_simplicial_complex_3`
*/
template <class Complex> struct Deformation_report
{
  /// A vertex that fell short of its destination.
  struct Unfinished_vertex
  {
    typename Complex::Vertex_handle vertex; ///< on the interface
    double distance;                        ///< from where it is to its destination
  };

  /// A cell whose quality is below `Complex::quality_floor`.
  struct Flat_cell
  {
    typename Complex::Cell_handle cell; ///< a finite cell
    double quality;                     ///< by the measure of the complex
  };

  /// What became of a label: its components, and its volume in the coordinates of the complex.
  struct Label_change
  {
    typename Complex::Label label = 0; ///< whose components these are
    std::size_t before = 0;            ///< number of components before
    std::size_t after = 0;             ///< number of components after
    std::size_t merged = 0;   ///< components that others merged into: before + split + appeared =
                              ///< after + merged + vanished
    std::size_t split = 0;    ///< components that fell off others
    std::size_t vanished = 0; ///< components of which no cell is left
    std::size_t appeared = 0; ///< components that come from none
    double volume_before = 0; ///< 0 if the label was not there
    double volume_after = 0;  ///< 0 if the label is gone
  };

  /// Where the time went, by the wall clock.
  struct Seconds
  {
    double extension = 0;    ///< finding how space follows the interface
    double motion = 0;       ///< moving vertices, and finding facets that degenerate
    double relabeling = 0;   ///< of cells that have become flat
    double obstacles = 0;    ///< removing what keeps vertices from their destinations
    double improvement = 0;  ///< of cells that have become bad
    double small_angles = 0; ///< removing them in the end
    double rest = 0;         ///< beginning and end
  };

  bool complete = true;                      ///< whether `unfinished` is empty
  std::vector<Unfinished_vertex> unfinished; ///< by time stamp
  std::vector<Flat_cell> flat;               ///< all of the complex, in the end, by time stamp
  /// vertices that were removed or left the interface, by a merge or a collapse, before they
  /// arrived
  std::size_t vanished = 0;
  /// vertices whose destinations lay outside the domain, a box: each was sent to the nearest point
  /// of the box instead
  std::size_t stopped_at_boundary = 0;
  unsigned passes = 0;  ///< executions of the main loop of Algorithm 1
  bool stopped = false; ///< whether the visitor ended it: `go_further()` was false
  /// \var split
  /// edges split
  /// \var collapsed
  /// edges collapsed, on the interface or off it
  /// \var flipped
  /// edges, sets of facets, and edges of the interface removed
  /// \var smoothed
  /// vertices smoothed
  /// \var inserted
  /// vertices inserted into cells
  std::size_t split = 0, collapsed = 0, flipped = 0, smoothed = 0, inserted = 0;
  /// vertices of the interface that were moved, from where they had come, to remove small angles:
  /// by a twentieth of the mean edge there, a quarter at most
  std::size_t relocated = 0;
  std::size_t relabeled = 0;        ///< cells that changed their label
  std::vector<Label_change> labels; ///< one for each label of before or after, increasing
  std::vector<Topology_event<Complex>> events;       ///< by pass
  std::vector<Neighbor_exchange<Complex>> exchanges; ///< in the plane only, in the end
  Seconds seconds;                                   ///< what alone differs from run to run
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORMATION_REPORT_H
