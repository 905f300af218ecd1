// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Cut_loci_2, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CUT_LOCI_2_INTERNAL_GEODESICS_DIRECTIONS_H
#define CGAL_CUT_LOCI_2_INTERNAL_GEODESICS_DIRECTIONS_H

#include <cmath>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Directions at a point are angles in radians. Angles increase to the left.

inline double full_turn() { return 2 * std::acos(-1.); }

// Returns the angle from a direction to another one, positive to the left, in [-pi, pi].
inline double turn(double from, double to) { return std::remainder(to - from, full_turn()); }

// Returns the angle in (0, 2 pi] from the direction `right` to the left, up to the direction
// `left`.
inline double gap_between(double right, double left) {
  const double gap = std::fmod(left - right, full_turn());
  return gap > 0 ? gap : gap + full_turn();
}

// Returns a direction as an angle in [0, 2 pi).
inline double canonical_angle(double angle) {
  const double a = std::fmod(angle, full_turn());
  return a < 0 ? a + full_turn() : a;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_CUT_LOCI_2_INTERNAL_GEODESICS_DIRECTIONS_H
