// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_LABELED_TETRAHEDRA_H
#define DSC_LABELED_TETRAHEDRA_H

#include "programs/errors.h"

#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Mesh_files/Mesh_arrays.h>
#include <CGAL/Mesh_files/Mesh_entities.h>
#include <CGAL/Mesh_files/Unused_content.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace dsc {

using DSC::Mesh_array;
using DSC::Mesh_arrays;
using DSC::Mesh_entities;
using DSC::Unused_content;

/// The tetrahedra of a file, with the points that they use.
struct Labeled_tetrahedra
{
  std::vector<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> points;
  std::vector<std::array<std::size_t, 4>> tetrahedra;
  std::vector<int> labels;
  Mesh_arrays arrays;     ///< of a VTU file
  Mesh_entities entities; ///< of a MEDIT file
  Unused_content unused;  ///< other contents of the file

  /// Moves arrays or entities to the unused content, for callers that do not use them.
  void leave_out_arrays();
  void leave_out_entities();

  /// Copies points at which the tetrahedra touch each other in a vertex or an edge only: each set
  /// of tetrahedra that are connected through facets at a point gets its own copy.
  void separate_touching_cells();
};

/// Reads a mesh (.mesh, .vtu) in the format of its extension.
/// \param label_array name of the array of a .vtu file that contains the labels; `none` for label 1
/// everywhere; empty for an array with a known name
/// \throws std::runtime_error if the mesh cannot be read
Labeled_tetrahedra read_tetrahedra(const std::string& path, const std::string& label_array);

/// Returns the place of an error in a mesh, in parentheses; empty if the place is not known.
std::string place_of(const DSC::Invalid_cells_error& error, const Labeled_tetrahedra& mesh);

} // namespace dsc

#endif // DSC_LABELED_TETRAHEDRA_H
