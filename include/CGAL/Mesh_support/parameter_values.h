// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_SUPPORT_PARAMETER_VALUES_H
#define CGAL_MESH_SUPPORT_PARAMETER_VALUES_H

#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/named_parameters.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <thread>
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
#define CGAL_add_named_parameter(X, Y, Z)                                                          \
  template <> struct Named_option<internal_np::X>                                                  \
  {                                                                                                \
    static constexpr const char* name = #Z;                                                        \
    template <class Options> static auto member(Options& options) -> decltype((options.Z)) {       \
      return options.Z;                                                                            \
    }                                                                                              \
  };
#include <CGAL/Mesh_support/named_parameter_list.h>
CGAL_add_named_parameter(number_of_iterations_t, number_of_iterations, number_of_iterations);
CGAL_add_named_parameter(visitor_t, visitor, visitor);
#undef CGAL_add_named_parameter

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

// Returns whether a struct of options, or one that it extends, has the name of a named parameter.
template <class Tag, class Options> constexpr bool is_option() {
  if constexpr (has_base_options<Options>)
    if (is_option<Tag, std::decay_t<decltype(base_options(std::declval<Options&>()))>>())
      return true;
  return has_option<Tag, Options>;
}

// Returns the tag of a named parameter of a chain that is neither the name of an option nor in
// `Others`; nothing if there is none.
template <class Options, class... Others, class T, class Tag, class Base>
auto find_untaken(const Named_function_parameters<T, Tag, Base>& np) {
  if constexpr (!is_option<Tag, Options>() &&
                !std::is_same<Tag, CGAL::internal_np::all_default_t>::value &&
                !(std::is_same<Tag, Others>::value || ...))
    return Tag();
  else if constexpr (!std::is_same<Base, CGAL::internal_np::No_property>::value)
    return find_untaken<Options, Others...>(static_cast<const Base&>(np));
}

// Does not compile if a function does not take a named parameter. The first lines of the message
// contain the tag of the parameter and the options of the function.
template <class Untaken_parameter, class Options> struct Named_parameter_check
{
  static_assert(std::is_void<Untaken_parameter>::value,
                "the function does not take this named parameter; the named parameters that it "
                "takes are members of its options");
};

// Returns the option with the name of a named parameter.
template <class Tag, class Options> auto& option_of(Options& options) {
  if constexpr (has_option<Tag, Options>)
    return Named_option<Tag>::member(options);
  else
    return option_of<Tag>(base_options(options));
}

// Whether an option can get a value. It gets the address of a value if it is a pointer.
template <class Option, class Value>
inline constexpr bool takes_value = std::is_pointer<Option>::value ||
                                    (std::is_same<Option, unsigned>::value
                                         ? std::is_integral<Value>::value
                                         : std::is_assignable<Option&, const Value&>::value);

// Returns whether the option with the name of a named parameter can get its value. Is true if
// there is no such option.
template <class Tag, class Options, class NamedParameters> constexpr bool takes_parameter() {
  if constexpr (is_option<Tag, Options>())
    return takes_value<
        std::decay_t<decltype(option_of<Tag>(std::declval<Options&>()))>,
        std::decay_t<decltype(parameter(std::declval<const NamedParameters&>(), Tag()))>>;
  else
    return true;
}

// Returns the tag of a named parameter whose value is not of the type of its option, except
// `Others`; nothing if there is none.
template <class Options, class... Others, class T, class Tag, class Base>
auto find_mistyped(const Named_function_parameters<T, Tag, Base>& np) {
  if constexpr (!(std::is_same<Tag, Others>::value || ...) &&
                !takes_parameter<Tag, Options, Named_function_parameters<T, Tag, Base>>())
    return Tag();
  else if constexpr (!std::is_same<Base, CGAL::internal_np::No_property>::value)
    return find_mistyped<Options, Others...>(static_cast<const Base&>(np));
}

// Does not compile if the value of a named parameter is not of the type of its option.
template <class Mistyped_parameter, class Options> struct Named_parameter_type_check
{
  static constexpr bool is_control =
      std::is_same<Mistyped_parameter, internal_np::topology_control_t>::value;
  static constexpr bool is_field =
      std::is_same<Mistyped_parameter, internal_np::sizing_field_t>::value;
  static_assert(!is_control,
                "TopologyControl: bool operator()(const Complex&, Cell_handle, int) const");
  static_assert(!is_field,
                "a sizing field is a function of points: double operator()(Point) const");
  static_assert(std::is_void<Mistyped_parameter>::value || is_control || is_field,
                "the value of a named parameter has the type of the member of the options with its "
                "name, or converts to it");
};

// Whether a type is that of a chain of named parameters.
template <class NamedParameters, class = void> inline constexpr bool is_chain = false;
template <class NamedParameters>
inline constexpr bool is_chain<NamedParameters, std::void_t<typename NamedParameters::base>> = true;

// Does not compile if named parameters are given that are members of the options of a function,
// but that the function does not take.
template <class Options, class... Tags, class NamedParameters>
void refuse_parameters(const NamedParameters&) {
  if constexpr (is_chain<NamedParameters>)
    (Named_parameter_check<std::conditional_t<is_given<NamedParameters, Tags>, Tags, void>,
                           Options>(),
     ...);
}

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
void replace_option([[maybe_unused]] const char* name, const Given& given, Value& value) {
  if constexpr (!takes_value<Value, Given>)
    return; // `Named_parameter_type_check` does not compile
  else if constexpr (std::is_same<Value, unsigned>::value) {
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
#define CGAL_add_named_parameter(X, Y, Z) internal::visit_option<internal_np::X>(options, f);
#include <CGAL/Mesh_support/named_parameter_list.h>
#undef CGAL_add_named_parameter
  internal::visit_option<internal_np::number_of_iterations_t>(options, f);
  internal::visit_option<internal_np::visitor_t>(options, f);
}

/*!
\ingroup PkgMeshSupportRef

Replaces the members of a struct of options that are given as named parameters with the same names,
also in the structs of options that `for_each_option()` visits. A count is an integer of any type. A
pointer is given as a `std::reference_wrapper`. Other ranges than that of counts are not checked. A
named parameter that is neither a member nor in `Others` does not compile.

\tparam Others tags of parameters that the caller reads
\param np the named parameters
\param options the options, with the default values
\throws Error if a count is negative
*/
template <class... Others, class NamedParameters, class Options>
void read_parameters(const NamedParameters& np, Options& options) {
  using Untaken_parameter = decltype(internal::find_untaken<Options, Others...>(np));
  internal::Named_parameter_check<Untaken_parameter, Options>();
  using Mistyped_parameter = decltype(internal::find_mistyped<Options, Others...>(np));
  internal::Named_parameter_type_check<Mistyped_parameter, Options>();
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

Returns the default value of the named parameter `number_of_threads` of a function: 1, or the number
of hardware threads for a parallel tag.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`.
        `Parallel_tag` does not compile without TBB.
*/
template <class ConcurrencyTag> unsigned default_number_of_threads() {
  static constexpr bool is_parallel = std::is_convertible<ConcurrencyTag, Parallel_tag>::value;
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!is_parallel, "Parallel_tag needs TBB: link with CGAL::TBB_support");
#endif
  return is_parallel ? (std::max)(1u, std::thread::hardware_concurrency()) : 1;
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
