// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Incompressible_fluids_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_UNIT_OF_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_UNIT_OF_H

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the largest power of two that is not above a positive number, or 1 for other numbers.
// Division by it is exact. So square roots and single precision give the same digits for all units
// that differ by a power of two.
inline double unit_of(double x) {
  if (!(x > 0) || !std::isfinite(x))
    return 1;
  // The inverse of the unit is a normal number, too.
  static constexpr int largest = std::numeric_limits<double>::max_exponent - 2;
  return std::ldexp(1., (std::max)(-largest, (std::min)(std::ilogb(x), largest)));
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_UNIT_OF_H
