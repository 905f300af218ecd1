// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_VISITOR_PARAMETER_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_VISITOR_PARAMETER_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Any_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/parameter_values.h>

#include <type_traits>
#include <utility>

namespace CGAL::Deformable_simplicial_complexes {

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
  using CGAL::internal_np::visitor_t;
  if constexpr (is_given<NamedParameters, visitor_t>) {
    using Given = std::decay_t<decltype(parameter(np, CGAL::internal_np::visitor))>;
    return Given_visitor<Complex, Given>(parameter(np, CGAL::internal_np::visitor));
  } else
    return Given_visitor<Complex, Deformation_visitor>(Deformation_visitor());
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_VISITOR_PARAMETER_H
