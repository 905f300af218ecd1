// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_IO_VTU_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_IO_VTU_2_H

#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/grids/write_vtu.h>

#include <string>

namespace CGAL {
namespace IO {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

writes all triangles of a planar complex as a VTK unstructured grid (`.vtu`), at height 0: otherwise
as `write_VTU()` does in space.

\param path is the name of the file; its folder must exist.
\param dsc is the complex.

\throws Deformable_simplicial_complexes::File_error if the file cannot be written; an older file
of that name is unchanged then.

n log n in the number of cells; takes memory for a second copy of the file.
*/
template <class Traits, class Tds, class Domain>
void write_VTU(const std::string& path,
               const Deformable_simplicial_complex_2<Traits, Tds, Domain>& dsc) {
  Deformable_simplicial_complexes::internal::write_cells_vtu(path, dsc);
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

writes the segments of the interface of a planar complex as a VTK unstructured grid (`.vtu`), at
height 0, the larger label on the left: otherwise as `write_interface_VTU()` does in space.

\param path is the name of the file; its folder must exist.
\param dsc is the complex; without an interface the file has no cells.

\throws Deformable_simplicial_complexes::File_error if the file cannot be written; an older file
of that name is unchanged then.

Linear in the number of cells, and n log n in the size of the interface.

\sa `extract_interface()`
*/
template <class Traits, class Tds, class Domain>
void write_interface_VTU(const std::string& path,
                         const Deformable_simplicial_complex_2<Traits, Tds, Domain>& dsc) {
  Deformable_simplicial_complexes::internal::write_facets_vtu(path, dsc);
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_IO_VTU_2_H
