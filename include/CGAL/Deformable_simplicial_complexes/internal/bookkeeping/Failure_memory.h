// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BOOKKEEPING_FAILURE_MEMORY_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BOOKKEEPING_FAILURE_MEMORY_H

#include <CGAL/Deformable_simplicial_complexes/simplex_bases.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Flags of cells for which an algorithm has failed, or which smoothing has improved only slightly.
// Such a cell is not tried again before motion changes its shape or the shape of a neighbor, or
// before a label changes there. A rigid motion thus causes no new attempt. Operations on adjacent
// cells cause none, either: an operation that improves one cell often worsens another, and the
// process would not terminate. Cells created by operations are new and have no flags. In a mesh at
// rest, smoothing that changes the shape of a cell clears its flags.

// The algorithms that record failures, each with a flag of its own.
enum Attempt : std::uint8_t {
  to_improve_quality = 1,
  to_remove_small_angles = 2 // greater bits are free for other algorithms
};

template <class Cell_handle> bool is_exhausted(Cell_handle c, Attempt attempt) {
  return (c->failures() & attempt) != 0;
}

template <class Cell_handle> void set_exhausted(Cell_handle c, Attempt attempt) {
  Simplex_access::set_failures(c, std::uint8_t(c->failures() | attempt));
}

template <class Cell_handle> void clear_exhausted(Cell_handle c, Attempt attempt) {
  Simplex_access::set_failures(c, std::uint8_t(c->failures() & ~attempt));
}

// Returns whether cells with two given qualities have different shapes. Differences due to rounding
// in flat cells are ignored.
inline bool is_essential_change(double before, double after) {
  static constexpr double same = .1, flat = 1e-9;
  return !(std::abs(after - before) <= same * (std::max)(before, flat));
}

// Returns whether the shape of a cell has changed since this function last returned true for it.
template <class Cell_handle> bool note_shape(Cell_handle c) {
  if (!is_essential_change(c->noted_quality(), c->quality()))
    return false;
  Simplex_access::set_noted_quality(c, float(c->quality()));
  return true;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BOOKKEEPING_FAILURE_MEMORY_H
