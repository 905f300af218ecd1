// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_REMESHING_INTERFACE_IMPROVER_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_REMESHING_INTERFACE_IMPROVER_H

#include <CGAL/Deformable_simplicial_complexes/Any_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Improvement_report.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_improvement_options.h>
#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>
#include <CGAL/Deformable_simplicial_complexes/internal/remeshing/Interface_improver_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/remeshing/Interface_improver_3.h>

#include <type_traits>

namespace CGAL::Deformable_simplicial_complexes::internal {

/*
An `Interface_remesher` with its dimension-specific operations:

- `reconnect()`: replaces interface facets without moving vertices
- `split_junctions()`: splits vertices where too many phases meet
*/
template <class Complex>
using Interface_improver =
    std::conditional_t<Complex::dimension == 2, Interface_improver_2<Complex>,
                       Interface_improver_3<Complex>>;

// Implements `improve_interface()`.
template <class Complex>
Improvement_report remesh_interface(Complex& dsc,
                                    const Interface_improvement_options<Complex>& options) {
  options.check();
  const Progress_phase phase("improving the interface");
  Any_visitor<Complex> no_visitor;
  Interface_improver<Complex> improver(dsc, options.visitor ? *options.visitor : no_visitor,
                                       options);
  for (unsigned i = 0; i < options.number_of_iterations; ++i) {
    if (options.split_junctions)
      improver.split_junctions();
    improver.split_long_edges();
    improver.collapse_short_edges();
    improver.reconnect();
    improver.smooth_vertices();
    improver.improve_cells();
  }
  return improver.report();
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_REMESHING_INTERFACE_IMPROVER_H
