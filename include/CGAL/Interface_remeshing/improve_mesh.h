// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Interface_remeshing, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_REMESHING_IMPROVE_MESH_H
#define CGAL_INTERFACE_REMESHING_IMPROVE_MESH_H

#include <CGAL/license/Interface_remeshing.h>

#include <CGAL/Deformable_simplicial_complexes/Deformation_options.h>
#include <CGAL/Deformable_simplicial_complexes/Improvement_report.h>
#include <CGAL/Interface_remeshing/Mesh_improvement_options.h>
#include <CGAL/Interface_remeshing/internal/patches/improve_whole_mesh.h>
#include <CGAL/Mesh_support/named_parameters.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceRemeshingRef

Improves the cells of a complex (Algorithm 3 of the paper; insertion: Klingner and Shewchuk 2007).
The operations are reconnection, smoothing, collapses, insertion of vertices, and splits of long
edges. Except for splits, each operation is done only if it raises the worst quality of the cells it
replaces. If the quality of a cell stays low, the cells around it are improved beyond the threshold,
to give it room. The interface is bitwise unchanged unless `smooth_interface` is set. Some passes
over the cells, then n log n in the number of cells below the threshold.

The quality is that of the complex's quality measure. If dihedral angles are important in 3D, choose
`Biased_minimum_sine_3`. The result is deterministic: random numbers come from generators with fixed
seeds.

\param dsc the complex
\param np a `Mesh_improvement_options`, or named parameters with the names of its members. A visitor, a
       model of `DeformationVisitor`, is given by value or by `std::reference_wrapper`.

\return the numbers of changes
\throws Error if a parameter is out of its range; the complex is then unchanged

After an exception of the visitor, the complex is valid.
*/
template <class Complex, class NamedParameters = parameters::Default_named_parameters>
Improvement_report improve_mesh(Complex& dsc, const NamedParameters& np = NamedParameters()) {
  return internal::call_with_parameters(
      dsc, np, Mesh_improvement_options<Complex>(),
      [&](const auto& options) { return internal::improve_whole_mesh(dsc, options); });
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_IMPROVE_MESH_H
