// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_CONTROL_DETAIL_H
#define CGAL_INTERFACE_REMESHING_CONTROL_DETAIL_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_options.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Interface_remeshing/Detail_options.h>
#include <CGAL/Interface_remeshing/internal/remeshing/Detail_controller.h>
#include <CGAL/Mesh_support/named_parameters.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceRemeshingRef

Splits long edges at their midpoints and collapses short ones ("detail control", sections 3.2.1 and
3.2.2 of the paper). Lengths are given in units of the target edge length, which is a sizing field,
or the mean edge length of the input's interface. Without a sizing field, an edge inside a label is
split only if it connects the interface with itself or with the boundary of the domain. These splits
give the interface room to move, and the mesh stays coarse elsewhere. Edges inside a label are
collapsed if neither end is on the interface or on the boundary of the domain.

Unless `change_interface` is set, the interface is bitwise unchanged. If it is set, the topology of
the interface and the lines and points where labels meet stay. Splits move the interface by the
rounding of the midpoints; collapses move it by the volume between the old and the new facets. No
collapse creates an edge that would be split.

\param dsc the complex
\param np a `Detail_options`, or named parameters with the names of its members. Function objects
       and a visitor, a `Deformation_visitor`, are given by value or by
       `std::reference_wrapper`.

\return the numbers of changes
\throws Error if a parameter is out of its range, or there is an interface, but neither a sizing
        field nor `dsc.mean_interface_edge()`. The complex is then unchanged.
\throws Error if the sizing field has a value that is not positive. After this exception, or one of
        the sizing field or of the visitor, the complex is valid.

A pass over the cells, with the stars of the ends of edges to be collapsed; then n log n in the
number of changed cells.
*/
template <class Complex, class NamedParameters = parameters::Default_named_parameters>
Improvement_report control_detail(Complex& dsc, const NamedParameters& np = NamedParameters()) {
  return internal::call_with_parameters(
      dsc, np, Detail_options<Complex>(),
      [&](const auto& options) { return internal::run_detail_control(dsc, options); });
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_CONTROL_DETAIL_H
