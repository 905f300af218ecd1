// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_EDGE_UNIT_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_EDGE_UNIT_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/exceptions.h>

#include <CGAL/Named_function_parameters.h>

#include <cmath>
#include <functional>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Target edge length: a sizing field of the user, or a constant.

Any number of threads can call one object at once if the sizing field permits this.

\tparam Complex a deformable simplicial complex
*/
template <class Complex> class Edge_unit
{
public:
  using Point =
      typename Complex::Approximate_point; ///< a position in the coordinates of the complex

  /// Constructs a constant target edge length, for a named parameter `sizing_field` that is not
  /// given.
  Edge_unit(const CGAL::internal_np::Param_not_found&, double constant) : m_constant(constant) {}
  /// Constructs the target edge length from a sizing field, which is copied.
  /// \param field function object `double field(Point p)`, callable as `const`, or a
  ///        `std::reference_wrapper` of one
  /// \param constant not used by `operator()()`
  template <class SizingField>
  Edge_unit(const SizingField& field, double constant)
      : m_constant(constant), m_field([field](const Point& p) { return double(field(p)); }) {}

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
      throw Error("the sizing field is not positive at a point of the domain: use lengths");
    return length;
  }

private:
  double m_constant;
  std::function<double(const Point&)> m_field;
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Throws an exception if a complex has an interface, but no mean edge of the initial interface to be
the unit of lengths. This happens if the complex was built without an interface. The time is
constant if there is such a mean edge.

\throws Error if there are vertices on the interface and `complex.mean_interface_edge()` is 0
*/
template <class Complex> void require_interface_edge(const Complex& complex) {
  if (!(complex.mean_interface_edge() > 0) && !complex.interface_vertices().empty())
    throw Error("there is no unit of lengths, as the complex was built without an interface; call "
                "measure_interface_edges()");
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

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

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_EDGE_UNIT_H
