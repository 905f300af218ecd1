// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_LABELLED_TETRAHEDRA_H
#define DSC_LABELLED_TETRAHEDRA_H

#include <CGAL/Deformable_simplicial_complex_3/exceptions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace dsc {

/// Tetrahedra as a file has them, with only those of its points that they use.
struct Labelled_tetrahedra
{
  std::vector<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> points;
  std::vector<std::array<std::size_t, 4>> tetrahedra;
  std::vector<int> labels;
};

/// Reads a mesh (.mesh, .vtu) in the format of its extension.
/// \throws std::runtime_error if that fails
Labelled_tetrahedra read_tetrahedra(const std::string& path);

/// Says in parentheses where in a mesh an error is, or nothing if that is not known.
std::string place_of(const CGAL::Deformable_simplicial_complexes::Invalid_tetrahedra_error& error,
                     const Labelled_tetrahedra& mesh);

} // namespace dsc

#endif // DSC_LABELLED_TETRAHEDRA_H
