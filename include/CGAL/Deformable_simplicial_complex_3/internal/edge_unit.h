// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_EDGE_UNIT_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_EDGE_UNIT_H

#include <CGAL/Deformable_simplicial_complex_3/exceptions.h>

#include <CGAL/Named_function_parameters.h>

#include <cmath>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// A length of the input that edges are measured by.
struct Constant_edge_unit
{
  static constexpr bool is_size_field = false;

  template <class Point> double operator()(const Point&) const { return length; }

  double length;
};

// The user's wish for the length of edges.
template <class SizeField> struct Size_field_edge_unit
{
  static constexpr bool is_size_field = true;

  template <class Point> double operator()(const Point& p) const {
    const double length = field(p);
    if (!(length > 0))
      throw Error("the size field is not positive at a point of the domain: use lengths");
    return length;
  }

  SizeField field;
};

// What the parameter size_field stands for; `constant` if it is not given.
inline Constant_edge_unit edge_unit(const CGAL::internal_np::Param_not_found&, double constant) {
  return {constant};
}
template <class SizeField>
Size_field_edge_unit<SizeField> edge_unit(const SizeField& field, double) {
  return {field};
}

template <class Complex, class Unit>
double length_in_units(const Complex& complex, typename Complex::Vertex_handle v,
                       typename Complex::Vertex_handle w, const Unit& unit) {
  const auto p = complex.position(v);
  const auto edge = complex.position(w) - p;
  return std::sqrt(edge.squared_length()) / unit(p + .5 * edge);
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_EDGE_UNIT_H
