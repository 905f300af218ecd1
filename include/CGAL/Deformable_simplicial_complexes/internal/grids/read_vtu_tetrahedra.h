// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_GRIDS_READ_VTU_TETRAHEDRA_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_GRIDS_READ_VTU_TETRAHEDRA_H

#include <CGAL/Deformable_simplicial_complexes/Mesh_arrays.h>
#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>
#include <CGAL/Deformable_simplicial_complexes/Unused_content.h>
#include <CGAL/Deformable_simplicial_complexes/internal/grids/Vtu_reader.h>
#include <CGAL/Deformable_simplicial_complexes/internal/grids/vtk_numbers.h>
#include <CGAL/Deformable_simplicial_complexes/internal/grids/vtu_cells.h>
#include <CGAL/Deformable_simplicial_complexes/internal/grids/vtu_labels.h>
#include <CGAL/Deformable_simplicial_complexes/internal/text/files.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The content of a VTU file with tetrahedra.
struct Vtu_tetrahedra
{
  std::vector<double> coordinates; // three for each point
  std::vector<std::array<std::size_t, 4>> tetrahedra;
  std::vector<int> labels;
  Mesh_arrays arrays; // on points and tetrahedra
  Unused_content unused;
};

// The arrays of numbers on points or cells; others are unused.
inline std::vector<Mesh_array> read_vtu_arrays(const Vtu_reader& reader, const std::string& section,
                                               std::size_t size, Unused_content& unused) {
  std::vector<Mesh_array> result;
  std::size_t numbers = 0;
  for (Mesh_array& array : reader.announced_arrays(section)) {
    Progress_scope::check();
    if (find_vtk_number_type(array.type) == nullptr) {
      unused.add("array without numbers (" + in_quotes(array.name) + ')');
      continue;
    }
    array.values = reader.array(section, array.name, size, array.components);
    numbers += array.values.size();
    if (numbers > reader.number_of_bytes())
      reader.fail("arrays of the section " + section + " share their data; write the grid again");
    result.push_back(std::move(array));
  }
  return result;
}

// Removes arrays of integers that `double` cannot hold.
inline void remove_inexact_arrays(std::vector<Mesh_array>& arrays, Unused_content& unused) {
  static constexpr double limit = 9007199254740992.; // 2^53
  const auto is_inexact = [&](const Mesh_array& array) {
    const bool result =
        array.is_integer() && !std::all_of(array.values.begin(), array.values.end(),
                                           [](double x) { return -limit < x && x < limit; });
    if (result)
      unused.add("array of integers with more than 53 bits (" + in_quotes(array.name) + ')');
    return result;
  };
  arrays.erase(std::remove_if(arrays.begin(), arrays.end(), is_inexact), arrays.end());
}

// Throws File_error if the file is not as described for `IO::read_VTU()`.
inline Vtu_tetrahedra read_vtu_tetrahedra(const std::string& path, const std::string& label_array) {
  const Progress_phase phase("reading tetrahedra");
  const Vtu_reader reader(path);
  const std::size_t number_of_points = reader.number_of_points();
  const std::size_t number_of_cells = reader.number_of_cells();
  if (number_of_cells == 0)
    reader.fail("there are no cells; choose a mesh with tetrahedra");
  Vtu_tetrahedra result;
  const std::vector<std::size_t> cells = vtu_tetrahedra(reader, number_of_cells, result.unused);
  result.coordinates = reader.array("Points", "", number_of_points, 3);
  for (std::size_t i = 0; i < result.coordinates.size(); ++i)
    if (!std::isfinite(result.coordinates[i]))
      reader.fail("a coordinate of point " + std::to_string(i / 3) +
                  " is not a finite number; correct it");
  result.tetrahedra = read_vtu_corners(reader, cells, number_of_cells, number_of_points);

  std::vector<Mesh_array>& on_cells = result.arrays.cells;
  result.arrays.points = read_vtu_arrays(reader, "PointData", number_of_points, result.unused);
  on_cells = read_vtu_arrays(reader, "CellData", number_of_cells, result.unused);
  if (cells.size() < number_of_cells)
    for (Mesh_array& array : on_cells)
      array = array.selected(cells);
  result.unused.add("arrays of field data", reader.number_of_global_arrays());

  const Vtu_label_choice choice(reader, on_cells);
  const std::size_t chosen = choice.find(label_array, result.unused);
  result.labels = choice.labels(chosen, cells);
  if (chosen != Vtu_label_choice::none) {
    const auto array = on_cells.begin() + static_cast<std::ptrdiff_t>(chosen);
    result.arrays.labels = {array->name, array->type, 1, {}};
    on_cells.erase(array);
  }
  remove_inexact_arrays(result.arrays.points, result.unused);
  remove_inexact_arrays(on_cells, result.unused);
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_GRIDS_READ_VTU_TETRAHEDRA_H
