// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_SUPPORT_NAMED_PARAMETERS_H
#define CGAL_MESH_SUPPORT_NAMED_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>

#include <functional>

/// \file
/// Named parameters of the package. They are in the namespace `CGAL::parameters` and are chained
/// with those of CGAL:
/// `deform_interface(dsc, destination, CGAL::parameters::visitor(v).quality_threshold(.3))`.

// Declares the parameters if the compiler did not find this package's extension of CGAL's list.
// Then chains that begin with a parameter of CGAL cannot continue with one of the package.
#ifndef CGAL_MESH_SUPPORT_PARAMETERS_ARE_IN_CGAL
/// \cond SKIP_IN_MANUAL
namespace CGAL {
namespace internal_np {

#define CGAL_add_named_parameter(X, Y, Z) enum X { Y };
#include <CGAL/Mesh_support/named_parameter_list.h>
#undef CGAL_add_named_parameter

// Chain of named parameters that begins with one of this package.
template <class T, class Tag, class Base = No_property>
struct Extended_named_parameters : Named_function_parameters<T, Tag, Base>
{
  using Named_function_parameters<T, Tag, Base>::Named_function_parameters;

#define CGAL_add_named_parameter(X, Y, Z)                                                          \
  template <class K>                                                                               \
  Extended_named_parameters<K, X, Extended_named_parameters> Z(const K& value) const {             \
    return {value, *this};                                                                         \
  }
// CGAL 6 has further forms of parameters, most of them of Mesh_3.
#define CGAL_add_named_parameter_with_compatibility(X, Y, Z) CGAL_add_named_parameter(X, Y, Z)
#define CGAL_add_extra_named_parameter_with_compatibility(X, Y, Z) CGAL_add_named_parameter(X, Y, Z)
#define CGAL_add_named_parameter_with_compatibility_cref_only(X, Y, Z)
#define CGAL_add_named_parameter_with_compatibility_ref_only(X, Y, Z)
#include <CGAL/STL_Extension/internal/parameters_interface.h>

#include <CGAL/Mesh_support/named_parameter_list.h>
#undef CGAL_add_named_parameter
#undef CGAL_add_named_parameter_with_compatibility
#undef CGAL_add_extra_named_parameter_with_compatibility
#undef CGAL_add_named_parameter_with_compatibility_cref_only
#undef CGAL_add_named_parameter_with_compatibility_ref_only
};

} // namespace internal_np

namespace parameters {

#define CGAL_add_named_parameter(X, Y, Z)                                                          \
  template <class K> internal_np::Extended_named_parameters<K, internal_np::X> Z(const K& value) { \
    return {value};                                                                                \
  }
#if CGAL_VERSION_NR < 1050600000
#define CGAL_MESH_SUPPORT_SIZING_FIELD_IS_AN_OBJECT
#endif
#include <CGAL/Mesh_support/named_parameter_list.h>
#undef CGAL_MESH_SUPPORT_SIZING_FIELD_IS_AN_OBJECT
#undef CGAL_add_named_parameter

} // namespace parameters
} // namespace CGAL
/// \endcond
#endif

// In CGAL 5.5, Mesh_3 has a keyword of the Boost Parameter Library with the name of a parameter of
// this package. An object serves both.
#if CGAL_VERSION_NR < 1050600000
/// \cond SKIP_IN_MANUAL
namespace boost::parameter {
template <class Tag> struct keyword;
}

namespace CGAL::parameters {

namespace tag {
struct sizing_field_;
}

template <class Keyword> struct Sizing_field_parameter
{
#ifdef CGAL_MESH_SUPPORT_PARAMETERS_ARE_IN_CGAL
  template <class K> using Chain = Named_function_parameters<K, internal_np::sizing_field_t>;
#else
  template <class K>
  using Chain = internal_np::Extended_named_parameters<K, internal_np::sizing_field_t>;
#endif
  template <class K> Chain<K> operator()(const K& value) const { return {value}; }
  template <class T> auto operator|(T&& value) const {
    return Keyword::instance | std::forward<T>(value);
  }
  template <class T> auto operator=(T&& value) const {
    return Keyword::instance = std::forward<T>(value);
  }
};

inline const Sizing_field_parameter<boost::parameter::keyword<tag::sizing_field_>> sizing_field{};

} // namespace CGAL::parameters
/// \endcond
#endif

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the object that a parameter given by value or by reference refers to.
template <class T> T& unwrap(T& value) { return value; }
template <class T> T& unwrap(std::reference_wrapper<T>& value) { return value.get(); }

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_SUPPORT_NAMED_PARAMETERS_H
