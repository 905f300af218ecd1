// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_COORDINATES_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_COORDINATES_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Deformable_simplicial_complexes {

template <class Result, int... i>
Result from_coordinates(const double* coordinates, std::integer_sequence<int, i...>) {
  return Result(coordinates[i]...);
}

// The point or vector of some type with these coordinates.
template <class Point, std::size_t d> Point point_of(const std::array<double, d>& coordinates) {
  return from_coordinates<Point>(coordinates.data(), std::make_integer_sequence<int, int(d)>());
}

// The point of a complex with these coordinates.
template <class Complex>
typename Complex::Approximate_point
point_at(const std::array<double, Complex::dimension>& coordinates) {
  return from_coordinates<typename Complex::Approximate_point>(
      coordinates.data(), std::make_integer_sequence<int, Complex::dimension>());
}

// The vector of a complex with these coordinates.
template <class Complex>
typename Complex::Approximate_vector
vector_of(const std::array<double, Complex::dimension>& coordinates) {
  return from_coordinates<typename Complex::Approximate_vector>(
      coordinates.data(), std::make_integer_sequence<int, Complex::dimension>());
}

// The coordinates of a point or vector.
template <int d, class Point> std::array<double, d> coordinates_of(const Point& p) {
  std::array<double, d> result;
  for (int axis = 0; axis < d; ++axis)
    result[axis] = p[axis];
  return result;
}

// The number of coordinates of a point, vector or array.
template <class Point> auto number_of_coordinates(const Point& p) -> decltype(p.dimension()) {
  return p.dimension();
}
template <std::size_t n> int number_of_coordinates(const std::array<double, n>&) { return int(n); }

// Whether all coordinates of a point or vector are numbers.
template <class Point> bool has_finite_coordinates(const Point& p) {
  bool result = true;
  for (int axis = 0; axis < number_of_coordinates(p); ++axis)
    result = result && std::isfinite(p[axis]);
  return result;
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_COORDINATES_H
