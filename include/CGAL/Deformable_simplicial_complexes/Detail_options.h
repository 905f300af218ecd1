// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DETAIL_OPTIONS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DETAIL_OPTIONS_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Any_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Edge_unit.h>
#include <CGAL/Deformable_simplicial_complexes/default_parameters.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/parameter_values.h>

#include <functional>
#include <limits>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Options of `control_detail()`. The named parameters of that function have the same names, and their
documentation describes the effects. Lengths are in units of the target edge length.

\tparam Complex a deformable simplicial complex
*/
template <class Complex> struct Detail_options
{
  /// Target edge length at a point. If empty, it is the mean edge of the initial interface.
  typename Edge_unit<Complex>::Sizing_field sizing_field;
  /// Selects the cells whose edges are split and collapsed. If empty, these are all cells.
  std::function<bool(typename Complex::Cell_handle)> where;
  /// Longer edges off the interface are split, greater than 0.
  double split_length = defaults::split_length;
  /// Shorter edges off the interface are collapsed, at least 0.
  double collapse_length = std::numeric_limits<double>::infinity();
  /// No collapse creates a cell of lower quality, in [0, 1].
  double collapse_quality = defaults::collapse_quality;
  /// Whether edges of the interface are split and collapsed, too.
  bool change_interface = false;
  /// Longer edges of the interface are split, greater than 0.
  double interface_split_length = defaults::interface_split_length;
  /// Shorter edges of the interface are collapsed, at least 0; without a sizing field, in units of
  /// the shortest edge of the initial interface.
  double interface_collapse_length = defaults::Interface_collapse_length::in_shortest_edges;
  /// Largest number of rounds.
  unsigned number_of_iterations = defaults::Number_of_iterations::over_mesh;
  /// Visitor of the changes, such as a `Visitor_adaptor`; it must outlive the call. None if null.
  Any_visitor<Complex>* visitor = nullptr;

  /// Throws an exception unless all values are in their ranges.
  /// \throws Error if a value is out of its range
  void check() const {
    if (!(split_length > 0 && interface_split_length > 0))
      throw Error("the length of edges to be split is out of range: use more than 0");
    if (!(collapse_length >= 0 && interface_collapse_length >= 0))
      throw Error("the length of edges to be collapsed is out of range: use 0 or more");
    require_quality(collapse_quality);
  }
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DETAIL_OPTIONS_H
