// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_VTU_3_H
#define CGAL_MESH_FILES_VTU_3_H

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Mesh_files/Mesh_arrays.h>
#include <CGAL/Mesh_files/Unused_content.h>
#include <CGAL/Mesh_files/internal/grids/read_vtu_tetrahedra.h>
#include <CGAL/Mesh_files/internal/grids/write_vtu.h>

namespace CGAL::IO {

/*!
\ingroup PkgMeshFilesRef

Writes all tetrahedra of a complex as a VTK unstructured grid (`.vtu`), for example for ParaView. n
log n in the number of cells; memory for a second copy of the file.

Points are in user coordinates. Points and cells are ordered by increasing time stamp. On a torus,
additional images of the vertices of cells across the seam follow. Cell data are `label` and
`quality`. Point data are `boundary_class`, which is 0 inside the domain, and `interface`, which is
1 on the interface and 0 elsewhere. Numbers are exact, and appended in binary form. A temporary file
in the same folder is written and renamed when complete.

\param path name of the file; its folder must exist
\param dsc the complex
\param arrays arrays with a row for each vertex, in the order of `dsc.vertices()`, or for each cell,
       in the order of `dsc.cells()`. Labels are also written under the name of `arrays.labels`, if
       it has one. Arrays with the name of an array that is always written are ignored. The names
       `arrays.label_names` are written as field data: `named_labels` and `label_names`.

\throws Deformable_simplicial_complexes::File_error if the file cannot be written; an older file of
        that name is then unchanged

\pre The types of the arrays are VTK names: `Int8` to `Int64`, `UInt8` to `UInt64`, `Float32`,
     `Float64`. The number of rows of each array is the number of vertices or of cells. Names do not
     contain the characters `"`, `&` and `<`, or they are escaped as in XML, as in the result of
     `read_VTU()`.
*/
template <class Traits, class Tds, class QualityMeasure, class Domain>
void write_VTU(const std::string& path,
               const Deformable_simplicial_complex_3<Traits, Tds, QualityMeasure, Domain>& dsc,
               const Deformable_simplicial_complexes::Mesh_arrays& arrays = {}) {
  Deformable_simplicial_complexes::internal::write_cells_vtu(path, dsc, arrays);
}

/*!
\ingroup PkgMeshFilesRef

Writes the triangles of the interface as a VTK unstructured grid (`.vtu`). Linear in the number of
cells, and n log n in the size of the interface.

Points are in user coordinates, and normals point out of the larger label. The cell data is
`label_pair`: the larger and the smaller label. Names of labels are field data. A temporary file in
the same folder is written and renamed when complete.

\param path name of the file; its folder must exist
\param dsc the complex; without an interface, the file has no cells
\param arrays arrays with a row for each vertex of the interface, in the order of
       `dsc.interface_vertices()`, or for each triangle, in the order of `dsc.interface_facets()`. A
       cell array with the name `label_pair` is ignored, and so is `arrays.labels`.

\throws Deformable_simplicial_complexes::File_error if the file cannot be written; an older file of
        that name is then unchanged

\pre Types, numbers of rows and names of the arrays are as for `write_VTU()`.

\sa `extract_interface()`
*/
template <class Traits, class Tds, class QualityMeasure, class Domain>
void write_interface_VTU(
    const std::string& path,
    const Deformable_simplicial_complex_3<Traits, Tds, QualityMeasure, Domain>& dsc,
    const Deformable_simplicial_complexes::Mesh_arrays& arrays = {}) {
  Deformable_simplicial_complexes::internal::write_facets_vtu(path, dsc, arrays);
}

/*!
\ingroup PkgMeshFilesRef

Reads labeled tetrahedra from a VTK unstructured grid (`.vtu`). The result is valid input of
`make_deformable_simplicial_complex_3()` and `Labeled_complex::assign()`. Linear in the size of the
file; memory for a few copies of the file.

The grid is a single piece of tetrahedra (cells of type 10); cells of lower dimension are ignored.
Numbers may be text, base64, or appended in base64 or binary form; they must not be compressed. The
geometry of the tetrahedra is not checked.

Labels are read from the cell array `label_array`. If no name is given, they are read from the first
existing array of `label`, `medit:ref`, `gmsh:physical` and `MaterialIDs`. If none of these exists
and no other cell array contains integers that may be labels, all labels are 1.

\tparam Point a point type that can be constructed from three coordinates

\param path name of the file
\param points, tetrahedra, labels replaced by the input; indices start from 0. Equal corners are
       merged; the first one counts.
\param label_array name of the cell array of the labels; `"none"` for label 1 everywhere; empty for
       the array with one of the names above
\param arrays replaced by all other arrays of numbers on points and tetrahedra, the name of the
       array of labels, and the names of labels, unless it is null
\param unused ignored cells and arrays are added to it, unless it is null. A second array with one
       of the names above is added if its values are different, and an array on points if its
       values differ at equal points. Other arrays of numbers are not added.

\throws Deformable_simplicial_complexes::File_error if the file cannot be opened, is not such a
        grid, contains no tetrahedra, or contains other three-dimensional cells. Also if arrays are
        missing or their sizes do not match the number of points or cells. Also if a coordinate is
        not finite, an index is out of range, or a label is not an integer of 32 bits. Also if the
        array of the labels is ambiguous; the message then lists all cell arrays. The arguments are
        then unchanged.
*/
template <class Point>
void read_VTU(const std::string& path, std::vector<Point>& points,
              std::vector<std::array<std::size_t, 4>>& tetrahedra, std::vector<int>& labels,
              const std::string& label_array = "",
              Deformable_simplicial_complexes::Mesh_arrays* arrays = nullptr,
              Deformable_simplicial_complexes::Unused_content* unused = nullptr) {
  auto read = Deformable_simplicial_complexes::internal::read_vtu_tetrahedra(path, label_array);
  std::vector<Point> new_points;
  new_points.reserve(read.points.size());
  for (const auto& [x, y, z] : read.points)
    new_points.emplace_back(x, y, z);
  points.swap(new_points);
  tetrahedra.swap(read.tetrahedra);
  labels.swap(read.labels);
  if (arrays != nullptr)
    *arrays = std::move(read.arrays);
  if (unused != nullptr)
    unused->add(read.unused);
}

} // namespace CGAL::IO

#endif // CGAL_MESH_FILES_VTU_3_H
