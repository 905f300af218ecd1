// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DISTRIBUTED_COMPLEXES_DISTRIBUTED_REPORT_H
#define CGAL_DISTRIBUTED_COMPLEXES_DISTRIBUTED_REPORT_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDistributedComplexesRef
Numbers of operations on a distributed complex.
*/
struct Distributed_counts
{
  using size_type = std::int64_t; ///< a number

  size_type rounds = 0;    ///< rounds of patches, of all ranks together
  size_type patches = 0;   ///< improved patches
  size_type split = 0;     ///< edges split
  size_type collapsed = 0; ///< edges collapsed
  size_type flipped = 0;   ///< edges, sets of facets, and edges of the interface removed
  size_type smoothed = 0;  ///< vertices smoothed
  size_type inserted = 0;  ///< vertices inserted into cells
  size_type relocated = 0; ///< vertices moved away to remove small angles
  size_type relabeled = 0; ///< cells that changed their label
  size_type vanished = 0;  ///< vertices that were removed, or left the interface

  /// Adds other numbers.
  Distributed_counts& operator+=(const Distributed_counts& other) {
    rounds += other.rounds;
    for (const auto member : sums())
      this->*member += other.*member;
    return *this;
  }

  /// Adds the numbers of a complex on one rank.
  Distributed_counts& operator+=(const Improvement_report& report) {
    split += size_type(report.split);
    collapsed += size_type(report.collapsed);
    flipped += size_type(report.flipped);
    smoothed += size_type(report.smoothed);
    inserted += size_type(report.inserted);
    return *this;
  }

  /// Returns the numbers that are sums over the ranks.
  static std::array<size_type Distributed_counts::*, 9> sums() {
    using Counts = Distributed_counts;
    return {&Counts::patches,   &Counts::split,     &Counts::collapsed,
            &Counts::flipped,   &Counts::smoothed,  &Counts::inserted,
            &Counts::relocated, &Counts::relabeled, &Counts::vanished};
  }
};

/*!
\ingroup PkgDistributedComplexesRef
Report of a motion of a distributed complex, equal on all ranks. Numbers are sums over all ranks.
\tparam Complex the type of a complex on one rank
*/
template <class Complex> struct Distributed_report : Distributed_counts
{
  bool complete = true;              ///< whether all vertices have arrived or vanished
  size_type unfinished = 0;          ///< vertices that did not reach their destinations
  double longest_remaining = 0;      ///< length of their longest remaining displacement
  size_type flat = 0;                ///< cells below `Complex::quality_floor`
  size_type stopped_at_boundary = 0; ///< vertices with destinations outside the domain, a box
  unsigned passes = 0;               ///< executions of the main loop of Algorithm 1
  /// one for each label before or after, by increasing label; `volume_swept` and
  /// `volume_of_overlaps` are not measured and 0
  std::vector<typename Deformation_report<Complex>::Label_change> labels;
  /// changes of components between the begin and the end of the motion. `where` is a point at which
  /// a patch changed the topology of this label; the origin if there is none.
  std::vector<Topology_event<Complex>> events;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DISTRIBUTED_COMPLEXES_DISTRIBUTED_REPORT_H
