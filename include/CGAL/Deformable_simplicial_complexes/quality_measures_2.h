// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_QUALITY_MEASURES_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_QUALITY_MEASURES_2_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/number_utils.h>

#include <cmath>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef
Quality measure of triangles: area divided by the mean squared edge length, times 4 / sqrt(3). It is
1 for the regular triangle, 0 for a degenerate one, and negative for an inverted one. It is
invariant under similarity transformations.
*/
struct Area_length_ratio_2
{
  /// Returns the quality of pqr.
  /// \tparam Point a point of a kernel whose coordinates are of type `double`
  template <class Point> double operator()(const Point& p, const Point& q, const Point& r) const {
    const double squared =
        (q - p).squared_length() + (r - q).squared_length() + (p - r).squared_length();
    return squared == 0 ? 0 : 2 * std::sqrt(3.) * determinant(q - p, r - p) / squared;
  }
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_QUALITY_MEASURES_2_H
