// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IO_READ_VTU_TETRAHEDRA_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IO_READ_VTU_TETRAHEDRA_H

#include <CGAL/Deformable_simplicial_complexes/internal/IO/Vtu_document.h>
#include <CGAL/Deformable_simplicial_complexes/internal/IO/Vtu_reader.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

struct Vtu_tetrahedra
{
  std::vector<double> coordinates; // three for each point
  std::vector<std::array<std::size_t, 4>> tetrahedra;
  std::vector<int> labels;
};

// What VTK calls a type of cells.
inline std::string vtk_cell_name(double type) {
  static constexpr std::pair<int, const char*> names[] = {{1, "vertex"},
                                                          {2, "poly-vertex"},
                                                          {3, "line"},
                                                          {4, "poly-line"},
                                                          {5, "triangle"},
                                                          {6, "triangle strip"},
                                                          {7, "polygon"},
                                                          {8, "pixel"},
                                                          {9, "quad"},
                                                          {11, "voxel"},
                                                          {12, "hexahedron"},
                                                          {13, "wedge"},
                                                          {14, "pyramid"},
                                                          {15, "pentagonal prism"},
                                                          {16, "hexagonal prism"},
                                                          {21, "quadratic edge"},
                                                          {22, "quadratic triangle"},
                                                          {23, "quadratic quad"},
                                                          {24, "quadratic tetrahedron"},
                                                          {25, "quadratic hexahedron"},
                                                          {26, "quadratic wedge"},
                                                          {27, "quadratic pyramid"},
                                                          {42, "polyhedron"},
                                                          {71, "Lagrange tetrahedron"},
                                                          {78, "Bezier tetrahedron"}};
  for (const auto& [number, name] : names)
    if (type == number)
      return std::string("a ") + name;
  return "of an unknown type";
}

inline void check_vtu_cells(const Vtu_reader& reader, std::size_t number_of_cells) {
  const std::vector<double> types = reader.array("Cells", "types", number_of_cells);
  for (std::size_t i = 0; i < types.size(); ++i)
    if (types[i] != Vtu_document::tetrahedron)
      reader.fail("cell " + std::to_string(i) + " is " + vtk_cell_name(types[i]) +
                  " and no tetrahedron; cut it into tetrahedra or leave it out");
  const std::vector<double> offsets = reader.array("Cells", "offsets", number_of_cells);
  for (std::size_t i = 0; i < offsets.size(); ++i)
    if (offsets[i] != 4 * (static_cast<double>(i) + 1))
      reader.fail("cell " + std::to_string(i) +
                  " does not have four vertices; correct the array 'offsets'");
}

// From the first array that there is, as other programs call it.
inline std::vector<int> read_vtu_labels(const Vtu_reader& reader, std::size_t number_of_cells) {
  for (const char* name : {"label", "medit:ref", "gmsh:physical", "MaterialIDs"})
    if (reader.has_array("CellData", name)) {
      std::vector<int> labels;
      for (const double label : reader.array("CellData", name, number_of_cells)) {
        using Limits = std::numeric_limits<int>;
        if (!(Limits::min() <= label && label <= Limits::max()) || label != std::trunc(label))
          reader.fail("the label of cell " + std::to_string(labels.size()) +
                      " is no integer of 32 bits; correct the array '" + name + "'");
        labels.push_back(static_cast<int>(label));
      }
      return labels;
    }
  return std::vector<int>(number_of_cells, 1);
}

// Throws File_error if the file is not as described for `IO::read_VTU()`.
inline Vtu_tetrahedra read_vtu_tetrahedra(const std::string& path) {
  const Vtu_reader reader(path);
  const std::size_t number_of_points = reader.number_of_points();
  const std::size_t number_of_cells = reader.number_of_cells();
  if (number_of_cells == 0)
    reader.fail("there are no cells; choose a mesh that has tetrahedra");
  check_vtu_cells(reader, number_of_cells);

  Vtu_tetrahedra result;
  result.coordinates = reader.array("Points", "", number_of_points, 3);
  for (std::size_t i = 0; i < result.coordinates.size(); ++i)
    if (!std::isfinite(result.coordinates[i]))
      reader.fail("a coordinate of point " + std::to_string(i / 3) +
                  " is not a finite number; correct it");

  const std::vector<double> indices = reader.array("Cells", "connectivity", number_of_cells, 4);
  result.tetrahedra.reserve(number_of_cells);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const double index = indices[i];
    if (!(0 <= index && index < static_cast<double>(number_of_points)) ||
        index != std::trunc(index))
      reader.fail("cell " + std::to_string(i / 4) +
                  " has a vertex that does not exist; correct the array 'connectivity'");
    if (i % 4 == 0)
      result.tetrahedra.emplace_back();
    result.tetrahedra.back()[i % 4] = static_cast<std::size_t>(index);
  }
  result.labels = read_vtu_labels(reader, number_of_cells);
  return result;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IO_READ_VTU_TETRAHEDRA_H
