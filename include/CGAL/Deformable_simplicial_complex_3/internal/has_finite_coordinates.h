// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_HAS_FINITE_COORDINATES_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_HAS_FINITE_COORDINATES_H

#include <cmath>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Whether the three coordinates of a point or vector are numbers.
template <class Coordinates> bool has_finite_coordinates(const Coordinates& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_HAS_FINITE_COORDINATES_H
