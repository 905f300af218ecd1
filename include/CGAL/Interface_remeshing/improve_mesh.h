// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Interface_remeshing, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_REMESHING_IMPROVE_MESH_H
#define CGAL_INTERFACE_REMESHING_IMPROVE_MESH_H

#include <CGAL/license/Interface_remeshing.h>

#include <CGAL/Deformable_simplicial_complexes/Any_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Improvement_report.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Mesh_improver.h>
#include <CGAL/Interface_remeshing/Mesh_improvement_options.h>
#include <CGAL/Interface_remeshing/internal/patches/Patch_improver_3.h>
#include <CGAL/Mesh_support/For_each_index.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/named_parameters.h>
#include <CGAL/Mesh_support/parameter_values.h>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// Implements `improve_mesh()`.
template <class Complex>
Improvement_report improve_whole_mesh(Complex& dsc,
                                      const Mesh_improvement_options<Complex>& options) {
  options.check();
  Any_visitor<Complex> no_visitor;
  Any_visitor<Complex>& visitor = options.visitor ? *options.visitor : no_visitor;
  const Progress_phase phase("improving the mesh");
  const double threshold = options.threshold();
  const unsigned rounds = options.number_of_iterations;
  const For_each_index for_each_index(options.number_of_threads);
  Mesh_improver<Complex> improver(dsc, visitor, threshold, for_each_index, true,
                                  options.smooth_interface);
  static constexpr int attempts = 5;
  improver.improve_all(threshold, rounds, attempts);
  if (!options.aggressive)
    return improver.report();
  Improvement_report patches;
  if constexpr (Complex::dimension == 3) { // in the plane, flips reach any triangulation
    Patch_improver_3<Complex> patch_improver(dsc, visitor, threshold, rounds, for_each_index);
    if (rounds > 0)
      patch_improver.run();
    patches = patch_improver.report();
  }
  improver.improve_all(threshold, rounds, 0);
  return improver.report() + patches;
}

} // namespace internal

/*!
\ingroup PkgInterfaceRemeshingRef

Does the same as `improve_mesh()` with named parameters.

\throws Error as that function does, see also `Mesh_improvement_options::check()`
*/
template <class Complex>
Improvement_report improve_mesh(Complex& dsc, const Mesh_improvement_options<Complex>& options) {
  return internal::improve_whole_mesh(dsc, options);
}

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
\param np named parameters with the names of the members of `Mesh_improvement_options`. A visitor, a
       model of `DeformationVisitor`, is given by value or by `std::reference_wrapper`.

\return the numbers of changes
\throws Error if a parameter is out of its range; the complex is then unchanged

After an exception of the visitor, the complex is valid.
*/
template <class Complex, class NamedParameters = parameters::Default_named_parameters>
Improvement_report improve_mesh(Complex& dsc, const NamedParameters& np = NamedParameters()) {
  namespace tags = internal_np;
  auto visitor = visitor_parameter<Complex>(np);
  Mesh_improvement_options<Complex> options;
  options.visitor = &visitor.any();
  replace_value(np, tags::quality_threshold, options.quality_threshold);
  replace_value(np, tags::aggressive, options.aggressive);
  replace_value(np, tags::smooth_interface, options.smooth_interface);
  replace_count(np, CGAL::internal_np::number_of_iterations, "number_of_iterations",
                options.number_of_iterations);
  replace_count(np, tags::number_of_threads, "number_of_threads", options.number_of_threads);
  return improve_mesh(dsc, options);
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_IMPROVE_MESH_H
