// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_SUPPORT_COORDINATES_H
#define CGAL_MESH_SUPPORT_COORDINATES_H

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgMeshSupportRef

Returns the point or vector of type `Result` with the coordinates `coordinates[i]...`. The functions
below are easier to call.

\pre `coordinates` has all these entries.
*/
template <class Result, int... i>
Result from_coordinates(const double* coordinates, std::integer_sequence<int, i...>) {
  return Result(coordinates[i]...);
}

/*!
\ingroup PkgMeshSupportRef

Returns the point or vector of type `Point` with `d` coordinates.
*/
template <class Point, std::size_t d> Point point_of(const std::array<double, d>& coordinates) {
  return from_coordinates<Point>(coordinates.data(), std::make_integer_sequence<int, int(d)>());
}

/*!
\ingroup PkgMeshSupportRef

Returns the point of type `Complex::Point` with given coordinates.
*/
template <class Complex>
typename Complex::Point point_at(const std::array<double, Complex::dimension>& coordinates) {
  return point_of<typename Complex::Point>(coordinates);
}

/*!
\ingroup PkgMeshSupportRef

Returns the vector of type `Complex::Vector` with given coordinates.
*/
template <class Complex>
typename Complex::Vector vector_of(const std::array<double, Complex::dimension>& coordinates) {
  return point_of<typename Complex::Vector>(coordinates);
}

/*!
\ingroup PkgMeshSupportRef

Returns the first `d` coordinates of a point, vector or array.
*/
template <int d, class Point> std::array<double, d> coordinates_of(const Point& p) {
  std::array<double, d> result;
  for (int axis = 0; axis < d; ++axis)
    result[axis] = p[axis];
  return result;
}

/*!
\ingroup PkgMeshSupportRef

Returns the number of coordinates of a point or vector of \cgal.
*/
template <class Point> auto number_of_coordinates(const Point& p) -> decltype(p.dimension()) {
  return p.dimension();
}
/// \ingroup PkgMeshSupportRef
/// Returns the number of coordinates of an array.
template <std::size_t n> int number_of_coordinates(const std::array<double, n>&) { return int(n); }

/*!
\ingroup PkgMeshSupportRef

Returns whether all coordinates of a point, vector or array are finite: neither infinite nor NaN.
*/
template <class Point> bool has_finite_coordinates(const Point& p) {
  bool result = true;
  for (int axis = 0; axis < number_of_coordinates(p); ++axis)
    result = result && std::isfinite(p[axis]);
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_MESH_SUPPORT_COORDINATES_H
