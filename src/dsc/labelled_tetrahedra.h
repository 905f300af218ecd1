// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_LABELLED_TETRAHEDRA_H
#define DSC_LABELLED_TETRAHEDRA_H

#include <CGAL/Deformable_simplicial_complexes/Mesh_arrays.h>
#include <CGAL/Deformable_simplicial_complexes/Mesh_entities.h>
#include <CGAL/Deformable_simplicial_complexes/Unused_content.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace dsc {

using CGAL::Deformable_simplicial_complexes::Mesh_array;
using CGAL::Deformable_simplicial_complexes::Mesh_arrays;
using CGAL::Deformable_simplicial_complexes::Mesh_entities;
using CGAL::Deformable_simplicial_complexes::Unused_content;

/// Tetrahedra as a file has them, with only those of its points that they use.
struct Labelled_tetrahedra
{
  std::vector<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> points;
  std::vector<std::array<std::size_t, 4>> tetrahedra;
  std::vector<int> labels;
  Mesh_arrays arrays;     ///< of a VTU file
  Mesh_entities entities; ///< of a MEDIT file
  Unused_content unused;  ///< what else is in the file

  /// Counts arrays and entities as unused, for what makes no use of them.
  void leave_out_arrays();
  void leave_out_entities();
};

/// Reads a mesh (.mesh, .vtu) in the format of its extension.
/// \param label_array is the name of the array of a .vtu file that holds the labels, `none` for
/// label 1 everywhere; empty for the one with a name that is known
/// \throws std::runtime_error if that fails
Labelled_tetrahedra read_tetrahedra(const std::string& path, const std::string& label_array);

/// Says in parentheses where in a mesh an error is, or nothing if that is not known.
std::string place_of(const CGAL::Deformable_simplicial_complexes::Invalid_cells_error& error,
                     const Labelled_tetrahedra& mesh);

} // namespace dsc

#endif // DSC_LABELLED_TETRAHEDRA_H
