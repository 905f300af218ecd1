// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_GRIDS_VTU_CELLS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_GRIDS_VTU_CELLS_H

#include <CGAL/Deformable_simplicial_complexes/Unused_content.h>
#include <CGAL/Deformable_simplicial_complexes/internal/grids/Vtu_document.h>
#include <CGAL/Deformable_simplicial_complexes/internal/grids/Vtu_reader.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A cell type of VTK.
struct Vtk_cell_type
{
  int number, dimension;
  const char *name, *plural;
};

// Returns the cell type with a given number, or null if it is unknown.
inline const Vtk_cell_type* find_vtk_cell_type(double number) {
  static constexpr Vtk_cell_type types[] = {
      {0, 0, "an empty cell", "empty cells"},
      {1, 0, "a vertex", "vertices"},
      {2, 0, "a poly-vertex", "poly-vertices"},
      {3, 1, "a line", "lines"},
      {4, 1, "a poly-line", "poly-lines"},
      {5, 2, "a triangle", "triangles"},
      {6, 2, "a triangle strip", "triangle strips"},
      {7, 2, "a polygon", "polygons"},
      {8, 2, "a pixel", "pixels"},
      {9, 2, "a quad", "quads"},
      {10, 3, "a tetrahedron", "tetrahedra"},
      {11, 3, "a voxel", "voxels"},
      {12, 3, "a hexahedron", "hexahedra"},
      {13, 3, "a wedge", "wedges"},
      {14, 3, "a pyramid", "pyramids"},
      {15, 3, "a pentagonal prism", "pentagonal prisms"},
      {16, 3, "a hexagonal prism", "hexagonal prisms"},
      {21, 1, "a quadratic edge", "quadratic edges"},
      {22, 2, "a quadratic triangle", "quadratic triangles"},
      {23, 2, "a quadratic quad", "quadratic quads"},
      {24, 3, "a quadratic tetrahedron", "quadratic tetrahedra"},
      {25, 3, "a quadratic hexahedron", "quadratic hexahedra"},
      {26, 3, "a quadratic wedge", "quadratic wedges"},
      {27, 3, "a quadratic pyramid", "quadratic pyramids"},
      {28, 2, "a biquadratic quad", "biquadratic quads"},
      {34, 2, "a biquadratic triangle", "biquadratic triangles"},
      {42, 3, "a polyhedron", "polyhedra"},
      {68, 1, "a Lagrange curve", "Lagrange curves"},
      {69, 2, "a Lagrange triangle", "Lagrange triangles"},
      {71, 3, "a Lagrange tetrahedron", "Lagrange tetrahedra"},
      {76, 2, "a Bezier triangle", "Bezier triangles"},
      {78, 3, "a Bezier tetrahedron", "Bezier tetrahedra"}};
  for (const Vtk_cell_type& type : types)
    if (type.number == number)
      return &type;
  return nullptr;
}

// Returns the indices of the tetrahedra among the cells. Counts cells of lower dimension as unused.
// Throws `File_error` if there are other cells of dimension 3, cells of unknown type, or no
// tetrahedra.
inline std::vector<std::size_t>
vtu_tetrahedra(const Vtu_reader& reader, std::size_t number_of_cells, Unused_content& unused) {
  const std::vector<double> types = reader.array("Cells", "types", number_of_cells);
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < types.size(); ++i) {
    const Vtk_cell_type* type = find_vtk_cell_type(types[i]);
    if (types[i] == Vtu_document::tetrahedron)
      result.push_back(i);
    else if (type == nullptr || type->dimension == 3)
      reader.fail("cell " + std::to_string(i) + " is " +
                  (type == nullptr ? "of an unknown type" : type->name) +
                  " and not a tetrahedron; divide it into tetrahedra or remove it");
    else
      unused.add(type->plural);
  }
  if (result.empty())
    reader.fail("there are no tetrahedra among the cells; choose a mesh with tetrahedra");
  return result;
}

// Returns the vertices of given cells, which are tetrahedra. Throws `File_error` if offsets or
// indices are invalid.
inline std::vector<std::array<std::size_t, 4>>
read_vtu_corners(const Vtu_reader& reader, const std::vector<std::size_t>& cells,
                 std::size_t number_of_cells, std::size_t number_of_points) {
  const std::vector<double> offsets = reader.array("Cells", "offsets", number_of_cells);
  for (std::size_t i = 0; i < offsets.size(); ++i)
    if (!(offsets[i] >= (i == 0 ? 0 : offsets[i - 1])) || offsets[i] != std::trunc(offsets[i]) ||
        offsets[i] > 1e15)
      reader.fail("cell " + std::to_string(i) +
                  " does not end after the previous cell; correct the array 'offsets'");
  const auto begin = [&](std::size_t i) {
    return i == 0 ? 0 : static_cast<std::size_t>(offsets[i - 1]);
  };
  for (const std::size_t i : cells)
    if (static_cast<std::size_t>(offsets[i]) != begin(i) + 4)
      reader.fail("cell " + std::to_string(i) +
                  " does not have four vertices; correct the array 'offsets'");

  const std::vector<double> indices = reader.array("Cells", "connectivity", begin(number_of_cells));
  std::vector<std::array<std::size_t, 4>> result;
  result.reserve(cells.size());
  for (const std::size_t cell : cells) {
    result.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) {
      const double index = indices[begin(cell) + k];
      if (!(0 <= index && index < static_cast<double>(number_of_points)) ||
          index != std::trunc(index))
        reader.fail("cell " + std::to_string(cell) +
                    " has a vertex that does not exist; correct the array 'connectivity'");
      result.back()[k] = static_cast<std::size_t>(index);
    }
  }
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_GRIDS_VTU_CELLS_H
