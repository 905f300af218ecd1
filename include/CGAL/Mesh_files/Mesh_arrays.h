// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_MESH_ARRAYS_H
#define CGAL_MESH_FILES_MESH_ARRAYS_H

#include <CGAL/Mesh_files/Label_names.h>

#include <cstddef>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgMeshFilesRef

A named array of numbers on the points or the cells of a mesh. Each point or cell has one row (a
tuple of VTK) of `components` numbers.
*/
struct Mesh_array
{
  std::string name;           ///< as in the file
  std::string type;           ///< VTK name of the type of the numbers: `Int32`, `Float64`, ...
  std::size_t components = 1; ///< numbers in a row
  std::vector<double> values; ///< row by row

  /// Returns whether the type is an integer type.
  bool is_integer() const { return type.find("Int") != std::string::npos; }

  /// Returns the number of rows. \pre `components` is not 0
  std::size_t rows() const { return values.size() / components; }

  /// Returns an array of the same name and type with the given rows, in this order.
  /// \pre each element of `rows` is less than `rows()`
  Mesh_array selected(const std::vector<std::size_t>& rows) const {
    Mesh_array result{name, type, components, {}};
    result.values.reserve(rows.size() * components);
    for (const std::size_t row : rows)
      for (std::size_t i = 0; i < components; ++i)
        result.values.push_back(values[row * components + i]);
    return result;
  }
};

/*!
\ingroup PkgMeshFilesRef

The arrays of a mesh that are neither coordinates nor labels, and the names of the labels.
*/
struct Mesh_arrays
{
  std::vector<Mesh_array> points; ///< arrays on points
  std::vector<Mesh_array> cells;  ///< arrays on cells

  /// array that the labels were read from, without its numbers; its name is empty if there was none
  Mesh_array labels;

  Label_names label_names; ///< names of labels
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_MESH_FILES_MESH_ARRAYS_H
