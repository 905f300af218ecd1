// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_IMPROVE_NEW_MESH_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_IMPROVE_NEW_MESH_H

#include <CGAL/Deformable_simplicial_complexes/Any_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>
#include <CGAL/Deformable_simplicial_complexes/default_parameters.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Mesh_improver.h>
#include <CGAL/Deformable_simplicial_complexes/parameter_values.h>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// The options for the improvement of a new complex, read from named parameters.
struct New_mesh_options
{
  double threshold;
  unsigned rounds;
  bool improve;
};

template <class NP> New_mesh_options new_mesh_options(const NP& np) {
  return {quality_parameter(np, internal_np::quality_threshold,
                            defaults::Quality_threshold::of_new_mesh),
          count_parameter(np, CGAL::internal_np::number_of_iterations, "number_of_iterations",
                          defaults::Number_of_iterations::over_mesh),
          parameter_or(np, internal_np::improve, true)};
}

// Improves a new mesh with the operations of a deformation step. Operations that add vertices
// inside cells are not used, because more vertices would only make deformations slower.
template <class Complex> void improve_new_mesh(Complex& dsc, const New_mesh_options& options) {
  const Progress_phase phase("improving the mesh");
  if (options.improve) {
    Any_visitor<Complex> visitor;
    Mesh_improver<Complex> improver(dsc, visitor, options.threshold);
    improver.improve_all(options.threshold, options.rounds, 0);
  }
  dsc.sort_storage();
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_IMPROVE_NEW_MESH_H
