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

// By what edges are measured: the user's wish for their length, a function of position, or a length
// of the input.
template <class Complex> class Edge_unit
{
public:
  using Point = typename Complex::Approximate_point;

  // The parameter sizing_field, or `constant` if it is not given.
  Edge_unit(const CGAL::internal_np::Param_not_found&, double constant) : m_constant(constant) {}
  template <class SizeField>
  Edge_unit(const SizeField& field, double constant)
      : m_constant(constant), m_field([field](const Point& p) { return double(field(p)); }) {}

  bool is_sizing_field() const { return bool(m_field); }

  double operator()(const Point& p) const {
    if (!is_sizing_field())
      return m_constant;
    const double length = m_field(p);
    if (!(length > 0))
      throw Error("the size field is not positive at a point of the domain: use lengths");
    return length;
  }

private:
  double m_constant;
  std::function<double(const Point&)> m_field;
};

// Throws if a complex has an interface, but no length that its edges are measured by.
template <class Complex> void require_interface_edge(const Complex& complex) {
  if (!(complex.mean_interface_edge() > 0) && !complex.interface_vertices().empty())
    throw Error("there is no unit of lengths, as the complex was built without an interface; call "
                "measure_interface_edges()");
}

template <class Complex>
double length_in_units(const Complex& complex, typename Complex::Vertex_handle v,
                       typename Complex::Vertex_handle w, const Edge_unit<Complex>& unit) {
  const auto edge = complex.displacement(v, w);
  return std::sqrt(edge.squared_length()) / unit(complex.position(v) + .5 * edge);
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_EDGE_UNIT_H
