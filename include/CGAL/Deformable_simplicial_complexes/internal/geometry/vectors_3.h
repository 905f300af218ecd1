// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_GEOMETRY_VECTORS_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_GEOMETRY_VECTORS_3_H

#include <array>
#include <cmath>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the normal of a triangle, towards the side from which it is counterclockwise. Its length
// is the area of the triangle.
template <class Point> auto area_vector(const std::array<Point, 3>& p) {
  return cross_product(p[1] - p[0], p[2] - p[0]) / 2;
}

// Returns the angle between two vectors, in radians. It is accurate for small angles, and 0 if a
// vector is zero.
template <class Vector> double angle_between(const Vector& a, const Vector& b) {
  return std::atan2(std::sqrt(cross_product(a, b).squared_length()), a * b);
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_GEOMETRY_VECTORS_3_H
