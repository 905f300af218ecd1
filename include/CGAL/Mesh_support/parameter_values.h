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

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

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

namespace internal {

// The name of a named parameter, and the member of a struct of options with this name.
template <class Tag> struct Named_option
{
};
#define CGAL_DSC_PARAMETER(NAME)                                                                   \
  template <> struct Named_option<internal_np::NAME##_t>                                           \
  {                                                                                                \
    static constexpr const char* name = #NAME;                                                     \
    template <class Options> static auto member(Options& options) -> decltype((options.NAME)) {    \
      return options.NAME;                                                                         \
    }                                                                                              \
  };
#include <CGAL/Mesh_support/named_parameter_list.h>

template <class Tag, class Options, class = void> inline constexpr bool has_option = false;
template <class Tag, class Options>
inline constexpr bool has_option<
    Tag, Options, std::void_t<decltype(Named_option<Tag>::member(std::declval<Options&>()))>> =
    true;

// Returns the struct of options that a struct of options extends.
template <class Options> auto base_options(Options& options) -> decltype((options.deformation)) {
  return options.deformation;
}
template <class Options> auto base_options(Options& options) -> decltype((options.advection)) {
  return options.advection;
}
template <class Options> auto base_options(Options& options) -> decltype((options.thin_parts)) {
  return options.thin_parts;
}

template <class Options, class = void> inline constexpr bool has_base_options = false;
template <class Options>
inline constexpr bool
    has_base_options<Options, std::void_t<decltype(base_options(std::declval<Options&>()))>> = true;

// Calls `f(name, value)` for the option with the name of a named parameter, if there is one.
template <class Tag, class Options, class F> void visit_option(Options& options, const F& f) {
  if constexpr (has_option<Tag, Options>)
    f(Named_option<Tag>::name, Named_option<Tag>::member(options));
  else if constexpr (has_base_options<Options>)
    visit_option<Tag>(base_options(options), f);
}

// Calls `f` with the tag of each parameter of a chain.
template <class T, class Tag, class Base, class F>
void for_each_tag(const Named_function_parameters<T, Tag, Base>& np, const F& f) {
  if constexpr (!std::is_same<Base, CGAL::internal_np::No_property>::value)
    for_each_tag(static_cast<const Base&>(np), f);
  f(Tag());
}

// Replaces an option by the value of a named parameter. Counts that are too large for `unsigned`
// are replaced by the largest `unsigned`.
template <class Given, class Value>
void replace_option(const char* name, const Given& given, Value& value) {
  if constexpr (std::is_same<Value, unsigned>::value) {
    static_assert(std::is_integral<Given>::value, "a count is an integer");
    if constexpr (std::is_signed<Given>::value)
      if (given < 0)
        throw Error(std::string(name) + " is negative: use 0 or more");
    value = static_cast<unsigned>(
        (std::min<std::uintmax_t>)(given, (std::numeric_limits<unsigned>::max)()));
  } else if constexpr (std::is_pointer<Value>::value)
    value = &given.get();
  else
    value = given;
}

} // namespace internal

/*!
\ingroup PkgMeshSupportRef

Calls a function for each member of a struct of options that has the name of a named parameter. The
members `deformation`, `advection` and `thin_parts` are structs of options, whose members are
visited, too.

\param options the struct
\param f function object, called as `f(name, value)` with the name and a reference to the member
*/
template <class Options, class F> void for_each_option(Options& options, const F& f) {
#define CGAL_DSC_PARAMETER(NAME) internal::visit_option<internal_np::NAME##_t>(options, f);
#include <CGAL/Mesh_support/named_parameter_list.h>
}

/*!
\ingroup PkgMeshSupportRef

Replaces the members of a struct of options that are given as named parameters with the same names,
also in the structs of options that `for_each_option()` visits. A count is an integer of any type. A
pointer is given as a `std::reference_wrapper`. Other ranges than that of counts are not checked.

\tparam Others tags of parameters that the caller reads
\param np the named parameters
\param options the options, with the default values
\throws Error if a count is negative
*/
template <class... Others, class NamedParameters, class Options>
void read_parameters(const NamedParameters& np, Options& options) {
  internal::for_each_tag(np, [&](auto tag) {
    using Tag = decltype(tag);
    if constexpr (!(std::is_same<Tag, Others>::value || ...))
      internal::visit_option<Tag>(options, [&](const char* name, auto& value) {
        internal::replace_option(name, parameter(np, Tag()), value);
      });
  });
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
