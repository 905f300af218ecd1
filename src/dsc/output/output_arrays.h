// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_OUTPUT_ARRAYS_H
#define DSC_OUTPUT_ARRAYS_H

#include <CGAL/Mesh_files/Mesh_arrays.h>

#include <functional>

namespace dsc {

/// The functions that compute the arrays of output files, such as the velocities of a fluid.
struct Output_arrays
{
  using Mesh_arrays = CGAL::Deformable_simplicial_complexes::Mesh_arrays;

  /// Returns the arrays for write_VTU().
  std::function<Mesh_arrays()> of_cells = [] { return Mesh_arrays(); };
  /// Returns the arrays for write_interface_VTU(). The first array on points, if there is one,
  /// contains velocities in space. Smooth surfaces have them, too.
  std::function<Mesh_arrays()> of_interface = [] { return Mesh_arrays(); };
};

} // namespace dsc

#endif // DSC_OUTPUT_ARRAYS_H
