// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Mesh_support, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MESH_SUPPORT_PARAMETER_VALUES_H
#define CGAL_MESH_SUPPORT_PARAMETER_VALUES_H

#include <CGAL/license/Mesh_support.h>

#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/named_parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>

// Functions that read named parameters and check their values.

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgMeshSupportRef

Whether a named parameter is given.

\tparam NamedParameters a chain of named parameters
\tparam Tag the tag of the parameter, of namespace `internal_np`
*/
template <class NamedParameters, class Tag>
inline constexpr bool is_given =
    !CGAL::parameters::is_default_parameter<NamedParameters, Tag>::value;

/*!
\ingroup PkgMeshSupportRef

Returns the value of a named parameter that is given.
*/
template <class NamedParameters, class Tag>
decltype(auto) parameter(const NamedParameters& np, Tag tag) {
  return CGAL::parameters::get_parameter(np, tag);
}

/*!
\ingroup PkgMeshSupportRef

Replaces a value by a named parameter, if this parameter is given. The range is not checked.

\param np the named parameters
\param tag the tag of the parameter
\param value the default value, to be replaced
*/
template <class NamedParameters, class Tag, class Value>
void replace_value(const NamedParameters& np, Tag tag, Value& value) {
  if constexpr (is_given<NamedParameters, Tag>)
    value = parameter(np, tag);
}

/*!
\ingroup PkgMeshSupportRef

Replaces a count by a named parameter, if this parameter is given. It is an integer of any type.
Counts that are too large for `unsigned` are replaced by the largest `unsigned`.

\param np the named parameters
\param tag the tag of the parameter
\param name name of the parameter in the message of the exception
\param value the default value, to be replaced
\throws Error if the count is negative, because the conversion would give a huge number
*/
template <class NamedParameters, class Tag>
void replace_count(const NamedParameters& np, Tag tag, const char* name, unsigned& value) {
  if constexpr (is_given<NamedParameters, Tag>) {
    const auto count = parameter(np, tag);
    static_assert(std::is_integral<decltype(count)>::value, "a count is an integer");
    if constexpr (std::is_signed<decltype(count)>::value)
      if (count < 0)
        throw Error(std::string(name) + " is negative: use 0 or more");
    value = static_cast<unsigned>(
        (std::min<std::uintmax_t>)(count, (std::numeric_limits<unsigned>::max)()));
  }
}

/*!
\ingroup PkgMeshSupportRef

Throws an exception unless a threshold of quality is in its range.

\throws Error if the value is not in [0, 1]
*/
inline void require_quality(double quality) {
  if (!(quality >= 0 && quality <= 1))
    throw Error("the quality threshold is out of range: use 0 to 1");
}

/*!
\ingroup PkgMeshSupportRef

Throws an exception unless an angle is in its range.

\param angle in degrees
\param largest the largest permitted angle, in degrees
\param name name of the angle in the message of the exception
\throws Error if the angle is not in [0, `largest`]
*/
inline void require_angle(double angle, int largest, const char* name) {
  if (!(angle >= 0 && angle <= largest))
    throw Error("the " + std::string(name) + " is out of range: use 0 to " +
                std::to_string(largest) + " degrees");
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_MESH_SUPPORT_PARAMETER_VALUES_H
