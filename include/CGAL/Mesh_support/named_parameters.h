// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Mesh_support, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MESH_SUPPORT_NAMED_PARAMETERS_H
#define CGAL_MESH_SUPPORT_NAMED_PARAMETERS_H

#include <CGAL/license/Mesh_support.h>

#include <CGAL/Named_function_parameters.h>

#include <functional>

/// \file
/// Named parameters of the package. They are chained like those of CGAL:
/// `deform_interface(dsc, destination, parameters::maximum_number_of_passes(20).visitor(v))` with
/// `namespace parameters = CGAL::Deformable_simplicial_complexes::parameters`.

namespace CGAL::Deformable_simplicial_complexes {
namespace internal_np {

/// \cond SKIP_IN_MANUAL
#define CGAL_DSC_PARAMETER(NAME) enum NAME##_t{NAME};
#define CGAL_DSC_PARAMETER_OF_CGAL(NAME)
#include <CGAL/Mesh_support/named_parameter_list.h>
/// \endcond

// For CGAL's own parameters, the package uses CGAL's tags.
using CGAL::internal_np::number_of_iterations_t;
using CGAL::internal_np::visitor_t;
using normal_map_t = CGAL::internal_np::normal_t;
using point_map_t = CGAL::internal_np::point_t;

} // namespace internal_np

/// Chain of named parameters: CGAL's class with the functions of this package.
template <class T, class Tag, class Base = CGAL::internal_np::No_property>
struct Named_parameters : public Named_function_parameters<T, Tag, Base>
{
  using Named_function_parameters<T, Tag, Base>::Named_function_parameters;

/// \cond SKIP_IN_MANUAL
#define CGAL_DSC_PARAMETER(NAME)                                                                   \
  template <class K>                                                                               \
  Named_parameters<K, internal_np::NAME##_t, Named_parameters> NAME(const K& value) const {        \
    return {value, *this};                                                                         \
  }
#include <CGAL/Mesh_support/named_parameter_list.h>
  /// \endcond
};

namespace parameters {

/// Type of an empty chain.
using Default_named_parameters = Named_parameters<bool, CGAL::internal_np::all_default_t>;

/// Returns an empty chain: every parameter has its default value.
inline Default_named_parameters default_values() { return {}; }

/// \cond SKIP_IN_MANUAL
#define CGAL_DSC_PARAMETER(NAME)                                                                   \
  template <class K> Named_parameters<K, internal_np::NAME##_t> NAME(const K& value) {             \
    return {value};                                                                                \
  }
#include <CGAL/Mesh_support/named_parameter_list.h>
/// \endcond

} // namespace parameters

namespace internal {

// Returns the object that a parameter given by value or by reference refers to.
template <class T> T& unwrap(T& value) { return value; }
template <class T> T& unwrap(std::reference_wrapper<T>& value) { return value.get(); }

} // namespace internal

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_MESH_SUPPORT_NAMED_PARAMETERS_H
