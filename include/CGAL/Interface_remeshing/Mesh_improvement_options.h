// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_MESH_IMPROVEMENT_OPTIONS_H
#define CGAL_INTERFACE_REMESHING_MESH_IMPROVEMENT_OPTIONS_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Mesh_support/parameter_values.h>

#include <optional>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceRemeshingRef

Options of `improve_mesh()`. The named parameters of that function have the same names.

\tparam Complex a deformable simplicial complex
*/
template <class Complex> struct Mesh_improvement_options
{
  /// Only cells of lower quality are improved, in [0, 1]. The higher it is, the more vertices are
  /// inserted. If empty, it is 0.25, and 0.46 if `aggressive`.
  std::optional<double> quality_threshold;
  /// Largest number of rounds. Each round processes the cells changed by the previous one. Where
  /// neighbors are improved, too, there are six times as many rounds.
  unsigned number_of_iterations = 10;
  /// Whether the cells around remaining cells of low quality are perturbed and improved repeatedly,
  /// in space only. This takes minutes instead of seconds.
  bool aggressive = false;
  /// Whether vertices of the interface may move within a plane or a line where the interface is
  /// flat or straight, see `propose_optimal_position()`, in space only.
  bool smooth_interface = false;
  /// Number of threads if linked with TBB. The result does not depend on it.
  unsigned number_of_threads = 1;
  /// Visitor of the changes; it must outlive the call. None if null.
  Deformation_visitor<Complex>* visitor = nullptr;

  /// Returns the threshold, or its default value.
  double threshold() const { return quality_threshold.value_or(aggressive ? .46 : .25); }

  /// Throws an exception unless all values are in their ranges.
  /// \throws Error if a value is out of its range
  void check() const { require_quality(threshold()); }
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_MESH_IMPROVEMENT_OPTIONS_H
