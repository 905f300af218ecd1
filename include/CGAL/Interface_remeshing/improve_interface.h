// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_IMPROVE_INTERFACE_H
#define CGAL_INTERFACE_REMESHING_IMPROVE_INTERFACE_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_options.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Interface_remeshing/Interface_improvement_options.h>
#include <CGAL/Interface_remeshing/internal/remeshing/Interface_remesher.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/named_parameters.h>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// Implements `improve_interface()`.
template <class Complex>
Improvement_report remesh_interface(Complex& dsc,
                                    const Interface_improvement_options<Complex>& options) {
  options.check();
  const Progress_phase phase("improving the interface");
  Deformation_visitor<Complex> no_visitor;
  Interface_remesher<Complex> improver(dsc, options.visitor ? *options.visitor : no_visitor,
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

} // namespace internal

/*!
\ingroup PkgInterfaceRemeshingRef

Improves the facets of the interface, with small changes of its shape (section 3.2.2 of the paper).
The function splits long edges, collapses short edges, and moves vertices along the interface
(null-space smoothing). In 3D, it also flips edges that do not fulfill the Delaunay criterion, and
removes facets with small angles. Cells around that become badly shaped are improved. A pass over
the cells and the stars of the vertices of the interface for each iteration.

The topology stays. Lines and points where more than two labels meet stay, except where edges or, on
request, junctions are split. Sharp edges and corners keep their shape: sharp edges are not flipped,
and their vertices move and collapse only along them. In 2D, corners stay. Smoothing keeps the
volumes of labels up to rounding; flips, collapses and curved splits change them slightly.

\param dsc the complex
\param np a `Interface_improvement_options`, or named parameters with the names of its members. Function
       objects and a visitor, a `Deformation_visitor`, are given by value or by
       `std::reference_wrapper`.

\return the numbers of changes
\throws Error if a parameter is out of its range, or there is an interface, but neither a sizing
        field nor `dsc.mean_interface_edge()`. The complex is then unchanged.
\throws Error if the sizing field has a value that is not positive. After this exception, or one of
        the sizing field, of `interface_energy` or of the visitor, the complex is valid.

*/
template <class Complex, class NamedParameters = parameters::Default_named_parameters>
Improvement_report improve_interface(Complex& dsc, const NamedParameters& np = NamedParameters()) {
  return internal::call_with_parameters(
      dsc, np, Interface_improvement_options<Complex>(),
      [&](const auto& options) { return internal::remesh_interface(dsc, options); });
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_IMPROVE_INTERFACE_H
