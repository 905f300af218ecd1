// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_PARAMETER_VALUES_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_PARAMETER_VALUES_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Any_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Edge_unit.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/named_parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <string>
#include <type_traits>
#include <utility>

// What functions that change a mesh read from their named parameters, checked.

namespace CGAL {
namespace Deformable_simplicial_complexes {

// The value of a parameter, or its default value.
template <class NamedParameters, class Tag, class Value>
auto parameter_or(const NamedParameters& np, Tag tag, const Value& default_value) {
  return CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, tag),
                                            default_value);
}

// A parameter that may be given as any number.
template <class NamedParameters, class Tag>
double number_parameter(const NamedParameters& np, Tag tag, double default_value) {
  return double(parameter_or(np, tag, default_value));
}

// A threshold of quality.
template <class NamedParameters, class Tag>
double quality_parameter(const NamedParameters& np, Tag tag, double default_value) {
  const double quality = number_parameter(np, tag, default_value);
  internal::check_threshold(quality);
  return quality;
}

// An angle in degrees, from 0 to the largest one. The error calls it by its name.
template <class NamedParameters, class Tag>
double angle_parameter(const NamedParameters& np, Tag tag, double default_value, int largest,
                       const char* name) {
  const double angle = number_parameter(np, tag, default_value);
  if (!(angle >= 0 && angle <= largest))
    throw Error("the " + std::string(name) + " is out of range: use 0 to " +
                std::to_string(largest) + " degrees");
  return angle;
}

// The size field, or else the mean edge of the input's interface.
template <class Complex, class NamedParameters>
Edge_unit<Complex> wanted_length(const Complex& complex, const NamedParameters& np) {
  const Edge_unit<Complex> result(CGAL::parameters::get_parameter(np, internal_np::sizing_field),
                                  complex.mean_interface_edge());
  if (!result.is_sizing_field())
    require_interface_edge(complex);
  return result;
}

// The size field, or else the shortest edge of the input's interface.
template <class Complex, class NamedParameters>
Edge_unit<Complex> shortest_wanted_length(const Complex& complex, const NamedParameters& np) {
  return {CGAL::parameters::get_parameter(np, internal_np::sizing_field),
          complex.minimum_interface_edge()};
}

// A visitor as it was given, by value or by reference, and what tells it of changes.
template <class Complex, class Given> class Given_visitor
{
public:
  explicit Given_visitor(Given given)
      : m_given(std::move(given)), m_any(internal::unwrap(m_given)) {}

  auto& visitor() { return internal::unwrap(m_given); }
  Any_visitor<Complex>& any() { return m_any; }

private:
  using Visitor = std::remove_reference_t<decltype(internal::unwrap(std::declval<Given&>()))>;

  Given m_given;
  Visitor_adaptor<Complex, Visitor> m_any;
};

// The visitor, by default one that does nothing.
template <class Complex, class NamedParameters> auto visitor_parameter(const NamedParameters& np) {
  auto given = parameter_or(np, CGAL::internal_np::visitor, Deformation_visitor());
  return Given_visitor<Complex, decltype(given)>(std::move(given));
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_PARAMETER_VALUES_H
