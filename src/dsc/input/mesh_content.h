// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_MESH_CONTENT_H
#define DSC_MESH_CONTENT_H

#include "input/labeled_tetrahedra.h"

#include <CGAL/Deformable_simplicial_complex_3.h>

namespace dsc {

/// The contents of a file of tetrahedra other than points and labels. Arrays are ordered by the
/// time stamps of the vertices and cells of a complex.
struct Mesh_content
{
  Mesh_arrays arrays;
  Mesh_entities entities;

  /// Returns whether there is nothing to transfer through changes of the complex.
  bool is_empty() const;
};

/// Returns the content of a mesh for the complex that was built from it.
/// \param unused receives the content that cannot follow changes of the complex: edges and
/// triangles that are not in the complex, arrays of integers that differ nearly everywhere, and
/// arrays with names of computed arrays
Mesh_content content_of(Labeled_tetrahedra mesh,
                        const CGAL::Deformable_simplicial_complex_3<>& complex,
                        Unused_content& unused);

/// Replaces the vertex indices of edges, triangles, corners and required vertices by new indices.
void renumber_vertices(Mesh_entities& entities, const std::vector<std::size_t>& new_indices);

} // namespace dsc

#endif // DSC_MESH_CONTENT_H
