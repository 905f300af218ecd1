// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_MESH_CONTENT_H
#define DSC_MESH_CONTENT_H

#include "labelled_tetrahedra.h"

#include <CGAL/Deformable_simplicial_complex_3.h>

namespace dsc {

/// What a file of tetrahedra holds besides points and labels, by the vertices and cells of a
/// complex in the order of their time stamps.
struct Mesh_content
{
  Mesh_arrays arrays;
  Mesh_entities entities;

  /// Returns whether nothing has to follow changes of the complex.
  bool is_empty() const;
};

/// Returns the content of a mesh for the complex that was made from it.
/// \param unused is told of what cannot follow changes of the complex: edges and triangles that are
/// none of it, arrays of integers that differ nearly everywhere, arrays named as those that are
/// written anyway
Mesh_content content_of(Labelled_tetrahedra mesh,
                        const CGAL::Deformable_simplicial_complex_3<>& complex,
                        Unused_content& unused);

/// Gives the vertices of edges, triangles and corners, and required vertices, their new indices.
void renumber_vertices(Mesh_entities& entities, const std::vector<std::size_t>& new_indices);

} // namespace dsc

#endif // DSC_MESH_CONTENT_H
