// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORMATION_REPORT_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORMATION_REPORT_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>

#include <cmath>
#include <cstddef>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef
Numbers of changes of the mesh. If the cells around a cell were replaced as a whole, this counts as
one flip. Vertices created, removed or moved thereby count as inserted, collapsed or smoothed.
*/
struct Improvement_report
{
  std::size_t split = 0;     ///< edges split
  std::size_t collapsed = 0; ///< edges collapsed
  std::size_t flipped = 0;   ///< edges and sets of facets removed
  std::size_t smoothed = 0;  ///< vertices smoothed
  std::size_t inserted = 0;  ///< vertices inserted into cells

  /// Adds the numbers of another report.
  Improvement_report& operator+=(const Improvement_report& other) {
    split += other.split;
    collapsed += other.collapsed;
    flipped += other.flipped;
    smoothed += other.smoothed;
    inserted += other.inserted;
    return *this;
  }

  /// Returns the sums of the numbers.
  friend Improvement_report operator+(Improvement_report a, const Improvement_report& b) {
    return a += b;
  }
};

namespace internal {

// In these functions, a Label_change is that of `Deformation_report`. Lists are ordered by label.

// Returns the change of a label, which is inserted if it is not there.
template <class Label_change>
Label_change& change_of_label(std::vector<Label_change>& changes, int label) {
  const auto it =
      std::lower_bound(changes.begin(), changes.end(), label,
                       [](const Label_change& change, int bound) { return change.label < bound; });
  if (it != changes.end() && it->label == label)
    return *it;
  Label_change change;
  change.label = label;
  return *changes.insert(it, change);
}

// Adds the volumes that explain a change.
template <class Label_change> void add_explained(const Label_change& from, Label_change& to) {
  to.volume_swept += from.volume_swept;
  to.volume_of_overlaps += from.volume_of_overlaps;
}

// Counts an event.
template <class Label_change>
void count_event(const Component_event& event, std::vector<Label_change>& changes) {
  Label_change& change = change_of_label(changes, event.label);
  switch (event.kind) {
  case Component_event::Kind::merged:
    change.merged += event.before.size() - 1;
    break;
  case Component_event::Kind::split:
    change.split += event.after.size() - 1;
    break;
  case Component_event::Kind::vanished:
    ++change.vanished;
    break;
  case Component_event::Kind::appeared:
    ++change.appeared;
    break;
  }
}

} // namespace internal

/*!
\ingroup PkgDeformableSimplicialComplexesRef
Exchange of neighbors in 2D, called a T1 event in foams. Two phases lose the wall between them, and
the two phases at its ends become neighbors.
\tparam Complex an instance of `Deformable_simplicial_complex_2`
*/
template <class Complex> struct Neighbor_exchange
{
  std::array<typename Complex::Label, 2> parted; ///< labels on both sides of the old wall
  /// labels on both sides of the new wall; there is none if they are equal, for example where a
  /// phase reaches a side of the domain
  std::array<typename Complex::Label, 2> joined;
  typename Complex::Point where; ///< midpoint of the old wall
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef
Report of a deformation. It names everything that was not reached or was lost. The numbers of
`Improvement_report` include the edges of the interface.
\tparam Complex a deformable simplicial complex
*/
template <class Complex> struct Deformation_report : Improvement_report
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
    /// volume that the interface sweeps if all vertices move along straight lines to their
    /// destinations, positive if the label gains it
    double volume_swept = 0;
    /// volume that the changes of topology explain: where parts of the interface meet, the swept
    /// volume counts their overlap, and the label does not lose it
    double volume_of_overlaps = 0;

    /// Returns the change of the volume that neither the motion of the interface nor changes of
    /// topology explain: of vertices that did not arrive, and of operations that changed the
    /// interface.
    double volume_unexplained() const {
      return volume_after - volume_before - volume_swept - volume_of_overlaps;
    }

    /// Appends the change in a deformation that followed at once.
    void append(const Label_change& next) {
      if (before == 0 && after == 0 && next.before > 0) {
        before = next.before;
        volume_before = next.volume_before;
      }
      after = next.after;
      volume_after = next.volume_after;
      for (const auto number : {&Label_change::merged, &Label_change::split,
                                &Label_change::vanished, &Label_change::appeared})
        this->*number += next.*number;
      internal::add_explained(next, *this);
    }

    /// Returns whether the unexplained volume is at most a thousandth of the volume.
    bool is_balanced() const {
      static constexpr double part = 1e-3;
      return std::abs(volume_unexplained()) <= part * (std::max)(volume_before, volume_after);
    }
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

  /// whether all vertices arrived at their destinations, except vertices that merged with others,
  /// and the volumes are balanced: `unfinished` is empty, `stopped_at_boundary` is 0, and
  /// `is_balanced()` returns true
  bool complete = true;
  std::vector<Unfinished_vertex> unfinished; ///< by increasing time stamp
  /// all flat cells of the complex at the end, by increasing time stamp
  std::vector<Flat_cell> flat;
  /// number of vertices that a collapse removed before they arrived
  std::size_t vanished = 0;
  /// number of vertices that left the interface before they arrived, because parts of the interface
  /// met
  std::size_t merged = 0;
  /// number of vertices with destinations outside the domain, a box; each was sent to the nearest
  /// point of the box
  std::size_t stopped_at_boundary = 0;
  /// estimated error of destinations due to the length of the time step, in the coordinates of the
  /// complex, summed over its parts; 0 if the velocity does not estimate it
  double estimated_error = 0;
  unsigned steps = 1;  ///< deformations into which a long time step was divided
  unsigned passes = 0; ///< executions of the main loop of Algorithm 1
  /// whether the visitor ended the deformation: `go_further()` returned false
  bool stopped = false;
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

  /// Appends the report of a deformation that followed at once: adds its numbers and lists, and
  /// replaces the lists of unfinished vertices and of flat cells. Vertices that did not arrive in
  /// the first deformation have new destinations in the second one, so `complete` tells of them
  /// only.
  void append(const Deformation_report& next) {
    complete = complete && next.complete;
    stopped = next.stopped;
    unfinished = next.unfinished;
    flat = next.flat;
    for (Topology_event<Complex> event : next.events) {
      event.pass += passes;
      events.push_back(event);
    }
    exchanges.insert(exchanges.end(), next.exchanges.begin(), next.exchanges.end());
    Improvement_report::operator+=(next);
    for (const auto number : {&Deformation_report::vanished, &Deformation_report::merged,
                              &Deformation_report::stopped_at_boundary,
                              &Deformation_report::relocated, &Deformation_report::relabeled})
      this->*number += next.*number;
    estimated_error += next.estimated_error;
    passes += next.passes;
    steps += next.steps;
    for (const auto part :
         {&Seconds::extension, &Seconds::motion, &Seconds::relabeling, &Seconds::obstacles,
          &Seconds::improvement, &Seconds::small_angles, &Seconds::rest})
      seconds.*part += next.seconds.*part;
    for (const Label_change& change : next.labels)
      internal::change_of_label(labels, change.label).append(change);
  }

  /// Returns whether the motion of the interface and changes of topology explain the change of the
  /// volume of each label, up to a thousandth of the volume.
  bool is_balanced() const {
    return std::all_of(labels.begin(), labels.end(),
                       [](const Label_change& change) { return change.is_balanced(); });
  }
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORMATION_REPORT_H
