// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_MESH_ENTITIES_H
#define CGAL_MESH_FILES_MESH_ENTITIES_H

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgMeshFilesRef

Entities of a MEDIT file other than points, tetrahedra and their labels. Edges and triangles with
references are used for boundary conditions, for example. Corners, ridges and required entities must
be preserved by remeshing. Indices start from 0.
*/
struct Mesh_entities
{
  /// Simplex: its vertices and their common reference.
  template <std::size_t n> struct Simplex
  {
    std::array<std::size_t, n> vertices; ///< indices of points
    int reference;                       ///< as in the file
  };

  std::vector<int> vertex_references; ///< one for each point; empty if all of them are 0
  std::vector<Simplex<2>> edges;      ///< listed edges
  std::vector<Simplex<3>> triangles;  ///< listed triangles

  std::vector<std::size_t> corners;            ///< indices of points
  std::vector<std::size_t> required_vertices;  ///< indices of points
  std::vector<std::size_t> ridges;             ///< indices of edges
  std::vector<std::size_t> required_edges;     ///< indices of edges
  std::vector<std::size_t> required_triangles; ///< indices of triangles
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_MESH_FILES_MESH_ENTITIES_H
