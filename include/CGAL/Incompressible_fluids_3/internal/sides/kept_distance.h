// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Incompressible_fluids_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SIDES_KEPT_DISTANCE_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SIDES_KEPT_DISTANCE_H

#include <algorithm>
#include <cmath>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the distance that a vertex keeps from a line or plane that it must not pass. Without the
// bound, the distance would change from `before` to `after`. Distances from -infinity to `near` are
// mapped to distances from near / 2 to `near`, so vertices one behind another keep their order. A
// vertex that was nearer does not come nearer.
inline double kept_distance(double before, double after, double near) {
  return after < near ? (std::min)(near / 2 * (1 + std::exp(2 * (after - near) / near)), before)
                      : after;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SIDES_KEPT_DISTANCE_H
