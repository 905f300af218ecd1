// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_VTU_2_H
#define CGAL_MESH_FILES_VTU_2_H

#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Mesh_files/Mesh_arrays.h>
#include <CGAL/Mesh_files/internal/grids/write_vtu.h>

namespace CGAL::IO {

/*!
\ingroup PkgMeshFilesRef

Writes all triangles of a complex in 2D as a VTK unstructured grid (`.vtu`), with z = 0. Otherwise
the function is the same as `write_VTU()` in 3D. n log n in the number of cells; memory for a second
copy of the file.
*/
template <class Traits, class Tds, class Domain>
void write_VTU(const std::string& path,
               const Deformable_simplicial_complex_2<Traits, Tds, Domain>& dsc,
               const Deformable_simplicial_complexes::Mesh_arrays& arrays = {}) {
  Deformable_simplicial_complexes::internal::write_cells_vtu(path, dsc, arrays);
}

/*!
\ingroup PkgMeshFilesRef

Writes the segments of the interface of a complex in 2D as a VTK unstructured grid (`.vtu`), with z
= 0 and the larger label on the left. Otherwise the function is the same as `write_interface_VTU()`
in 3D. Linear in the number of cells, and n log n in the size of the interface.
*/
template <class Traits, class Tds, class Domain>
void write_interface_VTU(const std::string& path,
                         const Deformable_simplicial_complex_2<Traits, Tds, Domain>& dsc,
                         const Deformable_simplicial_complexes::Mesh_arrays& arrays = {}) {
  Deformable_simplicial_complexes::internal::write_facets_vtu(path, dsc, arrays);
}

} // namespace CGAL::IO

#endif // CGAL_MESH_FILES_VTU_2_H
