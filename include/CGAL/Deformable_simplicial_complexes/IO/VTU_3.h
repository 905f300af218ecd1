// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_IO_VTU_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_IO_VTU_3_H

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/Mesh_arrays.h>
#include <CGAL/Deformable_simplicial_complexes/Unused_content.h>
#include <CGAL/Deformable_simplicial_complexes/internal/grids/read_vtu_tetrahedra.h>
#include <CGAL/Deformable_simplicial_complexes/internal/grids/write_vtu.h>

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace IO {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

writes all tetrahedra of a complex as a VTK unstructured grid (`.vtu`), for ParaView and the like.

Points are in user coordinates and come by increasing time stamp, as do the cells; on a torus,
further images of the vertices of cells across its seam follow. Cell data are
`label` and `quality`; point data are `boundary_class`, zero inside the domain, and `interface`, one
on the interface and zero elsewhere. Numbers are appended in binary form and exact. The file is
written beside its final place and renamed when complete.

\param path is the name of the file; its folder must exist.
\param dsc is the complex.

\throws Deformable_simplicial_complexes::File_error if the file cannot be written; an older file
of that name is unchanged then.

n log n in the number of cells; takes memory for a second copy of the file.
*/
template <class Traits, class Tds, class QualityMeasure, class Domain>
void write_VTU(const std::string& path,
               const Deformable_simplicial_complex_3<Traits, Tds, QualityMeasure, Domain>& dsc) {
  Deformable_simplicial_complexes::internal::write_cells_vtu(path, dsc);
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

writes all tetrahedra as above, with a vector for each point: velocities of a fluid, for example.

\tparam VectorAt is a function from `Vertex_handle` to a vector with coordinates 0 to 2 by `[]`.

\param path, dsc are as above.
\param name is that of the vectors among the point data; it contains none of the characters `"`, `&`
and `<`.
\param vector_at tells them.

\throws Deformable_simplicial_complexes::File_error as above.
*/
template <class Traits, class Tds, class QualityMeasure, class Domain, class VectorAt>
void write_VTU(const std::string& path,
               const Deformable_simplicial_complex_3<Traits, Tds, QualityMeasure, Domain>& dsc,
               const std::string& name, const VectorAt& vector_at) {
  Deformable_simplicial_complexes::internal::write_cells_vtu(
      path, dsc,
      [&](auto& document, const auto& vertices) {
        std::vector<double> numbers;
        for (const auto v : vertices) {
          const auto vector = vector_at(v);
          for (int axis = 0; axis < 3; ++axis)
            numbers.push_back(CGAL::to_double(vector[axis]));
        }
        document.array(name, numbers, 3);
      },
      [](auto&) {});
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

writes all tetrahedra as above, with further arrays.

\param path, dsc are as above.
\param arrays have a row for each vertex, in the order of `dsc.vertices()`, or for each cell, in the
order of `dsc.cells()`. Labels are also written under the name of `arrays.labels`, if it has one.
Arrays named as those that are written anyway are left out.

\throws Deformable_simplicial_complexes::File_error as above.

\pre the types of the arrays are names of VTK: `Int8` to `Int64`, `UInt8` to `UInt64`, `Float32`,
`Float64`. Each array has as many rows as there are vertices or cells. Names contain none of the
characters `"`, `&` and `<`, or they are written as in XML, as `read_VTU()` leaves them.
*/
template <class Traits, class Tds, class QualityMeasure, class Domain>
void write_VTU(const std::string& path,
               const Deformable_simplicial_complex_3<Traits, Tds, QualityMeasure, Domain>& dsc,
               const Deformable_simplicial_complexes::Mesh_arrays& arrays) {
  Deformable_simplicial_complexes::internal::write_cells_vtu(path, dsc, arrays);
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

writes the triangles of the interface as a VTK unstructured grid (`.vtu`).

Points are in user coordinates, and normals point out of the larger label. Cell data is
`label_pair`: the larger and the smaller label. The file is written beside its final place and
renamed when complete.

\param path is the name of the file; its folder must exist.
\param dsc is the complex; without an interface the file has no cells.

\throws Deformable_simplicial_complexes::File_error if the file cannot be written; an older file
of that name is unchanged then.

Linear in the number of cells, and n log n in the size of the interface.

\sa `extract_interface()`
*/
template <class Traits, class Tds, class QualityMeasure, class Domain>
void write_interface_VTU(
    const std::string& path,
    const Deformable_simplicial_complex_3<Traits, Tds, QualityMeasure, Domain>& dsc) {
  Deformable_simplicial_complexes::internal::write_facets_vtu(path, dsc);
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

reads labelled tetrahedra from a VTK unstructured grid (`.vtu`), as
`make_deformable_simplicial_complex_3()` and `Deformable_simplicial_complex_3::assign()` take them.

The grid is a single piece of tetrahedra (cells of type 10); cells of lower dimensions are left out.
Numbers may be text, base64 or appended, in base64 or in binary form, but not compressed. What the
tetrahedra look like is not checked.

Labels are those of the cell array `label_array`. If no array is named, they are those of the first
of the arrays `label`, `medit:ref`, `gmsh:physical` and `MaterialIDs` that there is. If there is
none of these, and no other cell array of whole numbers that could be meant, all labels are 1.

\tparam Point is a point type that can be constructed from three coordinates.

\param path is the name of the file.
\param points, tetrahedra, labels are replaced by what was read; indices start from 0.
\param label_array is the name of the cell array that holds the labels; `"none"` for label 1
everywhere; empty for the array with one of the names above.
\param arrays is replaced by all other arrays of numbers on points and tetrahedra, and the name of
the array of labels, unless it is null.
\param unused is told of cells and arrays that are left out, and of a second array with one of the
names above that differs, unless it is null. Other arrays of numbers are not listed there.

\throws Deformable_simplicial_complexes::File_error if the file cannot be opened or is no such grid,
arrays are missing or do not have as many numbers as there are points or cells, there are no
tetrahedra, or other cells that fill space, a coordinate is not finite, an index refers to no point,
a label is not an integer of 32 bits, or it is not clear which array holds the labels: the message
lists all cell arrays then. The arguments are unchanged then.

Linear in the size of the file; takes memory for a few copies of it.
*/
template <class Point>
void read_VTU(const std::string& path, std::vector<Point>& points,
              std::vector<std::array<std::size_t, 4>>& tetrahedra, std::vector<int>& labels,
              const std::string& label_array = "",
              Deformable_simplicial_complexes::Mesh_arrays* arrays = nullptr,
              Deformable_simplicial_complexes::Unused_content* unused = nullptr) {
  auto read = Deformable_simplicial_complexes::internal::read_vtu_tetrahedra(path, label_array);
  std::vector<Point> new_points;
  new_points.reserve(read.coordinates.size() / 3);
  for (std::size_t i = 0; i < read.coordinates.size(); i += 3)
    new_points.emplace_back(read.coordinates[i], read.coordinates[i + 1], read.coordinates[i + 2]);
  points.swap(new_points);
  tetrahedra.swap(read.tetrahedra);
  labels.swap(read.labels);
  if (arrays != nullptr)
    *arrays = std::move(read.arrays);
  if (unused != nullptr)
    for (const auto& [kind, number] : read.unused.numbers())
      unused->add(kind, number);
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_IO_VTU_3_H
