// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_IMPROVEMENT_REPORT_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_IMPROVEMENT_REPORT_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

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

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_IMPROVEMENT_REPORT_H
