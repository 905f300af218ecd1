// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Interface_remeshing, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_REMESHING_INTERNAL_PATCHES_IMPROVE_WHOLE_MESH_H
#define CGAL_INTERFACE_REMESHING_INTERNAL_PATCHES_IMPROVE_WHOLE_MESH_H

#include <CGAL/Deformable_simplicial_complexes/Any_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Improvement_report.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Mesh_improver.h>
#include <CGAL/Interface_remeshing/Mesh_improvement_options.h>
#include <CGAL/Interface_remeshing/internal/patches/Patch_improver_3.h>
#include <CGAL/Mesh_support/For_each_index.h>
#include <CGAL/Mesh_support/Progress_scope.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

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

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INTERFACE_REMESHING_INTERNAL_PATCHES_IMPROVE_WHOLE_MESH_H
