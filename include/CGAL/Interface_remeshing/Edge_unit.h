// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_EDGE_UNIT_H
#define CGAL_INTERFACE_REMESHING_EDGE_UNIT_H

#include <CGAL/Deformable_simplicial_complexes/internal/traversal/local_edge_length.h>

#include <cmath>
#include <functional>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceRemeshingRef

Target edge length: a sizing field of the user, or a constant.

Any number of threads can call one object at once if the sizing field permits this.

\tparam Complex a deformable simplicial complex
*/
template <class Complex> class Edge_unit
{
public:
  using Point = typename Complex::Point; ///< a position in the coordinates of the complex

  /// A sizing field: the target edge length at a point, in the coordinates of the complex.
  using Sizing_field = std::function<double(const Point&)>;

  /// Constructs the target edge length from a sizing field. If the field is empty, the length is
  /// the constant.
  Edge_unit(Sizing_field field, double constant)
      : m_constant(constant), m_field(std::move(field)) {}

  /// Returns whether the target edge length is a sizing field of the user.
  bool is_sizing_field() const { return bool(m_field); }

  /// Returns the target edge length at a point, in the coordinates of the complex.
  /// \throws Error if the sizing field is not positive at `p`. An exception of the sizing field
  ///         passes through.
  double operator()(const Point& p) const {
    if (!is_sizing_field())
      return m_constant;
    const double length = m_field(p);
    if (!(length > 0))
      throw Error(
          "the sizing field is not positive at a point of the domain: return positive lengths");
    return length;
  }

private:
  double m_constant;
  Sizing_field m_field;
};

/*!
\ingroup PkgInterfaceRemeshingRef

Returns the target edge length: the sizing field, or the mean edge of the initial interface if the
sizing field is empty.

\throws Error if the sizing field is empty, and the complex was built without an interface and has one
        now, so that it has no unit of length
*/
template <class Complex>
Edge_unit<Complex> target_edge_length(const Complex& complex,
                                      const typename Edge_unit<Complex>::Sizing_field& field) {
  if (!field)
    require_interface_edge(complex);
  return {field, complex.mean_interface_edge()};
}

/*!
\ingroup PkgInterfaceRemeshingRef

Returns the unit of lengths for collapses: the sizing field, or the shortest edge of the initial
interface if the sizing field is empty. This edge is 0 if the complex was built without an
interface.
*/
template <class Complex>
Edge_unit<Complex>
shortest_target_edge_length(const Complex& complex,
                            const typename Edge_unit<Complex>::Sizing_field& field) {
  return {field, complex.minimum_interface_edge()};
}

/*!
\ingroup PkgInterfaceRemeshingRef

Returns the length of the edge between `v` and `w` divided by the target edge length at its
midpoint. The time is constant apart from the sizing field.

\throws Error if the sizing field is not positive there
*/
template <class Complex>
double length_in_units(const Complex& complex, typename Complex::Vertex_handle v,
                       typename Complex::Vertex_handle w, const Edge_unit<Complex>& unit) {
  const auto edge = complex.displacement(v, w);
  return std::sqrt(edge.squared_length()) / unit(complex.position(v) + .5 * edge);
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_EDGE_UNIT_H
