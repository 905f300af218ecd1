// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BOOKKEEPING_FAILURE_MEMORY_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BOOKKEEPING_FAILURE_MEMORY_H

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Cells that were tried in vain, or that smoothing made but little better, are not tried again
// before motion gives another shape to them or to a neighbor, or a label changes there: not in a
// rigid motion. Nor after operations on cells next to them, as what is good for one is often bad
// for another, and there would be no end to it; but cells that operations make are new, and at rest
// smoothing that changes a shape makes it worth trying.

// The algorithms that remember their failures, each by itself.
enum Attempt : std::uint8_t { to_improve_quality = 1, to_remove_small_angles = 2 };

template <class Cell_handle> bool is_exhausted(Cell_handle c, Attempt attempt) {
  return (c->failures() & attempt) != 0;
}

template <class Cell_handle> void set_exhausted(Cell_handle c, Attempt attempt) {
  c->set_failures(std::uint8_t(c->failures() | attempt));
}

template <class Cell_handle> void clear_exhausted(Cell_handle c, Attempt attempt) {
  c->set_failures(std::uint8_t(c->failures() & ~attempt));
}

// Whether a cell of one quality has another shape than one of another, up to what rounding does to
// those that are flat.
inline bool is_essential_change(double before, double after) {
  static constexpr double same = .1, flat = 1e-9;
  return !(std::abs(after - before) <= same * (std::max)(before, flat));
}

// Returns whether a cell has another shape than when this was last the case.
template <class Cell_handle> bool note_shape(Cell_handle c) {
  if (!is_essential_change(c->noted_quality(), c->quality()))
    return false;
  c->set_noted_quality(float(c->quality()));
  return true;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BOOKKEEPING_FAILURE_MEMORY_H
