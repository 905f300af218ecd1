// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Complex_construction, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_COMPLEX_CONSTRUCTION_INTERNAL_THIN_PARTS_IMPROVE_NEW_MESH_H
#define CGAL_COMPLEX_CONSTRUCTION_INTERNAL_THIN_PARTS_IMPROVE_NEW_MESH_H

#include <CGAL/Complex_construction/Construction_options.h>
#include <CGAL/Complex_construction/refine_thin_parts.h>
#include <CGAL/Deformable_simplicial_complexes/Any_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Mesh_improver.h>
#include <CGAL/Mesh_support/For_each_index.h>
#include <CGAL/Mesh_support/Progress_scope.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Resolves thin parts of a mesh that was just made, improves it, and sorts its storage.
template <class Complex>
void improve_new_mesh(Complex& dsc, const Construction_options<Complex::dimension>& options) {
  if constexpr (Complex::Domain::has_outside)
    refine_thin_parts(dsc, options.thin_parts);
  const Progress_phase phase("improving the mesh");
  if (options.improve) {
    Any_visitor<Complex> visitor;
    const For_each_index sequential;
    Mesh_improver<Complex> improver(dsc, visitor, options.quality_threshold, sequential);
    improver.improve_all(options.quality_threshold, options.number_of_iterations, 0);
  }
  dsc.sort_storage();
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_COMPLEX_CONSTRUCTION_INTERNAL_THIN_PARTS_IMPROVE_NEW_MESH_H
