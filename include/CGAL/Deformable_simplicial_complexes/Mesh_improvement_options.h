// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_MESH_IMPROVEMENT_OPTIONS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_MESH_IMPROVEMENT_OPTIONS_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Any_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/default_parameters.h>
#include <CGAL/Deformable_simplicial_complexes/parameter_values.h>

#include <optional>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Options of `improve_mesh()`. The named parameters of that function have the same names, and their
documentation describes the effects.

\tparam Complex a deformable simplicial complex
*/
template <class Complex> struct Mesh_improvement_options
{
  /// Cells of lower quality are improved, in [0, 1]. If empty, the default depends on `aggressive`,
  /// see `defaults::Quality_threshold`.
  std::optional<double> quality_threshold;
  /// Largest number of rounds.
  unsigned number_of_iterations = defaults::Number_of_iterations::over_mesh;
  /// Whether the neighborhoods of the remaining cells are perturbed and improved again. In 3D only.
  bool aggressive = false;
  /// Whether vertices of the interface may move where the interface is flat, in space.
  bool smooth_interface = false;
  /// Number of threads if linked with TBB. The result does not depend on it.
  unsigned number_of_threads = defaults::number_of_threads;
  /// Visitor of the changes, such as a `Visitor_adaptor`; it must outlive the call. None if null.
  Any_visitor<Complex>* visitor = nullptr;

  /// Returns the threshold, or its default value.
  double threshold() const {
    using Default = defaults::Quality_threshold;
    return quality_threshold.value_or(aggressive ? Default::of_mesh_if_aggressive
                                                 : Default::of_mesh);
  }

  /// Throws an exception unless all values are in their ranges.
  /// \throws Error if a value is out of its range
  void check() const { require_quality(threshold()); }
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_MESH_IMPROVEMENT_OPTIONS_H
