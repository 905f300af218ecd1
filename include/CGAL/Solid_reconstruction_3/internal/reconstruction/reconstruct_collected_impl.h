// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Solid_reconstruction_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_RECONSTRUCT_COLLECTED_IMPL_H
#define CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_RECONSTRUCT_COLLECTED_IMPL_H

#include <CGAL/Solid_reconstruction_3/internal/clouds/Sampled_surface_3.h>
#include <CGAL/Solid_reconstruction_3/internal/reconstruction/Cloud_shell_3.h>
#include <CGAL/Solid_reconstruction_3/internal/reconstruction/Reconstructor_3.h>
#include <CGAL/Solid_reconstruction_3/reconstruct_point_set_3.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

template <class Complex>
Complex reconstruct_collected(const Collected_points& points,
                              const Reconstruction_options_3<Complex>& options) {
  const Sampled_surface_3 surface(points.points, points.normals, options.keep_open,
                                  options.number_of_threads);
  const Cloud_shell_3 shell(surface);
  Complex complex = complex_of_shell<Complex>(shell);
  Reconstructor_3<Complex> reconstructor(complex, surface, shell.edge(), options.fit_tolerance,
                                         options.number_of_threads);
  const auto report = reconstructor.run(options.number_of_iterations, options.observer);
  if (options.report)
    *options.report = report;
  return complex;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_RECONSTRUCT_COLLECTED_IMPL_H
