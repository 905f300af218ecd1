// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_MESH_CONTENT_H
#define DSC_MESH_CONTENT_H

#include "input/labeled_tetrahedra.h"

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>

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

/// Returns the arrays of a file that can follow changes of a complex.
/// \param unused receives the others: numbers of points and cells, and arrays with names of computed
/// arrays
Mesh_arrays carried_arrays(Mesh_arrays arrays, Unused_content& unused);

/// A complex whose domain can have any shape.
using Solid_complex =
    CGAL::Deformable_simplicial_complex_3<CGAL::Epick, CGAL::Default, DSC::Volume_length_ratio_3,
                                          DSC::Solid_domain>;

/// Returns the content of a mesh for the complex that was built from it.
/// \param vertices the vertices of the points of the mesh
/// \param format extension of the output file: `vtu` for arrays, `mesh` for entities
/// \param unused receives the rest of the file: what this format cannot store, and what cannot follow
/// changes of the complex, such as edges that are not in the complex
Mesh_content content_of(Labeled_tetrahedra mesh, const Solid_complex& complex,
                        const std::vector<Solid_complex::Vertex_handle>& vertices,
                        const std::string& format, Unused_content& unused);

/// Replaces the vertex indices of edges, triangles, corners and required vertices by new indices.
void renumber_vertices(Mesh_entities& entities, const std::vector<std::size_t>& new_indices);

} // namespace dsc

#endif // DSC_MESH_CONTENT_H
