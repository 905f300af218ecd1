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

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

// Functions that read and check named parameters.

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Returns the value of a named parameter, or a default value.

\param np the named parameters
\param tag the tag of the parameter, of namespace `CGAL::internal_np`
\param default_value returned if the parameter is not given
*/
template <class NamedParameters, class Tag, class Value>
auto parameter_or(const NamedParameters& np, Tag tag, const Value& default_value) {
  return CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, tag),
                                            default_value);
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Returns the value of a named parameter that can be a number of any type, or a default value. The
range is not checked.
*/
template <class NamedParameters, class Tag>
double number_parameter(const NamedParameters& np, Tag tag, double default_value) {
  return double(parameter_or(np, tag, default_value));
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Returns a count that is given as an integer of any type, or its default value.

\param np named parameters
\param tag tag of the parameter
\param name name of the parameter in the message of the exception
\param default_value value if the parameter is not given
\throws Error if the count is negative, because the conversion would give a huge number
*/
template <class NamedParameters, class Tag>
unsigned count_parameter(const NamedParameters& np, Tag tag, const char* name,
                         unsigned default_value) {
  const auto count =
      CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, tag), default_value);
  static_assert(std::is_integral<decltype(count)>::value, "a count is an integer");
  if constexpr (std::is_signed<decltype(count)>::value)
    if (count < 0)
      throw Error(std::string(name) + " is negative: use 0 or more");
  return static_cast<unsigned>(
      (std::min<std::uintmax_t>)(count, (std::numeric_limits<unsigned>::max)()));
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Returns the value of a named parameter that is a quality, or a default value.

\throws Error if the value is not in [0, 1]
*/
template <class NamedParameters, class Tag>
double quality_parameter(const NamedParameters& np, Tag tag, double default_value) {
  const double quality = number_parameter(np, tag, default_value);
  internal::check_threshold(quality);
  return quality;
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Returns the value of a named parameter that is an angle, or a default value.

\param np the named parameters
\param tag the tag of the parameter
\param default_value in degrees
\param largest the largest permitted angle, in degrees
\param name name of the parameter in the message of the exception
\throws Error if the value is not in [0, `largest`]
*/
template <class NamedParameters, class Tag>
double angle_parameter(const NamedParameters& np, Tag tag, double default_value, int largest,
                       const char* name) {
  const double angle = number_parameter(np, tag, default_value);
  if (!(angle >= 0 && angle <= largest))
    throw Error("the " + std::string(name) + " is out of range: use 0 to " +
                std::to_string(largest) + " degrees");
  return angle;
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Returns the target edge length: the named parameter `sizing_field`, or the mean edge of the initial
interface.

\throws Error if there is no sizing field, and `require_interface_edge()` throws
*/
template <class Complex, class NamedParameters>
Edge_unit<Complex> target_edge_length(const Complex& complex, const NamedParameters& np) {
  const Edge_unit<Complex> result(CGAL::parameters::get_parameter(np, internal_np::sizing_field),
                                  complex.mean_interface_edge());
  if (!result.is_sizing_field())
    require_interface_edge(complex);
  return result;
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Returns the unit of lengths for collapses: the named parameter `sizing_field`, or the shortest edge
of the initial interface. The latter is 0 if the complex was built without an interface.
*/
template <class Complex, class NamedParameters>
Edge_unit<Complex> shortest_target_edge_length(const Complex& complex, const NamedParameters& np) {
  return {CGAL::parameters::get_parameter(np, internal_np::sizing_field),
          complex.minimum_interface_edge()};
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

A visitor of a named parameter, stored by value or by `std::reference_wrapper`, with an
`Any_visitor` that calls it. An object cannot be copied, because the `Any_visitor` refers to its
visitor.

\tparam Complex a deformable simplicial complex
\tparam Given a model of `DeformationVisitor`, or a `std::reference_wrapper` of one
*/
template <class Complex, class Given> class Given_visitor
{
public:
  /// Stores the visitor.
  explicit Given_visitor(Given given)
      : m_given(std::move(given)), m_any(internal::unwrap(m_given)) {}

  /// Returns the visitor itself, for example to call `go_further()`.
  auto& visitor() { return internal::unwrap(m_given); }
  /// Returns the object that passes calls to the visitor.
  Any_visitor<Complex>& any() { return m_any; }

private:
  using Visitor = std::remove_reference_t<decltype(internal::unwrap(std::declval<Given&>()))>;

  Given m_given;
  Visitor_adaptor<Complex, Visitor> m_any;
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Returns the named parameter `visitor`, or a `Deformation_visitor`, which does nothing.
*/
template <class Complex, class NamedParameters> auto visitor_parameter(const NamedParameters& np) {
  auto given = parameter_or(np, CGAL::internal_np::visitor, Deformation_visitor());
  return Given_visitor<Complex, decltype(given)>(std::move(given));
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_PARAMETER_VALUES_H
