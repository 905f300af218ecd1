// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_INTERNAL_GRIDS_READ_VTU_TETRAHEDRA_H
#define CGAL_MESH_FILES_INTERNAL_GRIDS_READ_VTU_TETRAHEDRA_H

#include <CGAL/Mesh_files/Mesh_arrays.h>
#include <CGAL/Mesh_files/Unused_content.h>
#include <CGAL/Mesh_files/internal/grids/Merged_corners.h>
#include <CGAL/Mesh_files/internal/grids/Vtu_document.h>
#include <CGAL/Mesh_files/internal/grids/Vtu_reader.h>
#include <CGAL/Mesh_files/internal/grids/vtk_numbers.h>
#include <CGAL/Mesh_files/internal/text/files.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/coordinates.h>

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

// Returns the vertices of given cells, which have `corners` vertices each. Throws `File_error` if
// offsets or indices are invalid.
template <class Index>
std::vector<std::array<Index, 4>>
read_vtu_corners(const Vtu_reader& reader, const std::vector<std::size_t>& cells,
                 std::size_t number_of_cells, std::size_t number_of_points, std::size_t corners) {
  static constexpr const char* names[] = {"no", "one", "two", "three", "four"};
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
    if (static_cast<std::size_t>(offsets[i]) != begin(i) + corners)
      reader.fail("cell " + std::to_string(i) + " does not have " + names[corners] +
                  " vertices; correct the array 'offsets'");

  const std::vector<double> indices = reader.array("Cells", "connectivity", begin(number_of_cells));
  std::vector<std::array<Index, 4>> result;
  result.reserve(cells.size());
  for (const std::size_t cell : cells) {
    result.emplace_back();
    for (std::size_t k = 0; k < corners; ++k) {
      const double index = indices[begin(cell) + k];
      if (!(0 <= index && index < static_cast<double>(number_of_points)) ||
          index != std::trunc(index))
        reader.fail("cell " + std::to_string(cell) +
                    " has a vertex that does not exist; correct the array 'connectivity'");
      result.back()[k] = static_cast<Index>(index);
    }
  }
  return result;
}

inline bool is_vtu_label(double value) {
  using Limits = std::numeric_limits<int>;
  return Limits::min() <= value && value <= Limits::max() && value == std::trunc(value);
}

// The choice of the cell array that contains the labels.
class Vtu_label_choice
{
public:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  Vtu_label_choice(const Vtu_reader& reader, const std::vector<Mesh_array>& arrays)
      : m_reader(reader), m_arrays(arrays) {}

  // Returns the index of the array with a name. An empty name means the first array with a name
  // known for labels; "none" means no array. Returns `none` if all labels are 1. Throws
  // `File_error` if there is no array with the name, or if the name is empty and only arrays with
  // unknown names may be labels.
  std::size_t find(const std::string& name, Unused_content& unused) const {
    if (name == "none")
      return none;
    if (!name.empty()) {
      const std::size_t chosen = index_of(name);
      if (chosen == none)
        refuse("there is no cell array " + in_quotes(name));
      return chosen;
    }
    std::size_t result = none;
    for (const char* known : {"label", "medit:ref", "gmsh:physical", "MaterialIDs"}) {
      const std::size_t i = index_of(known);
      if (result == none)
        result = i;
      else if (i != none && m_arrays[i].values != m_arrays[result].values)
        unused.add("other array of labels (" + in_quotes(known) + ", ignored in favor of " +
                   in_quotes(m_arrays[result].name) + ')');
    }
    if (result == none && std::any_of(m_arrays.begin(), m_arrays.end(), may_be_labels))
      refuse("no cell array has a known name for labels");
    return result;
  }

  // Returns the labels in an array. `cells` contains the indices of the cells in the file, for
  // messages. Throws `File_error` if a value is not a label.
  std::vector<int> labels(std::size_t chosen, const std::vector<std::size_t>& cells) const {
    if (chosen == none)
      return std::vector<int>(cells.size(), 1);
    const Mesh_array& array = m_arrays[chosen];
    if (array.components != 1)
      refuse("the cell array " + in_quotes(array.name) + " has " +
             std::to_string(array.components) + " numbers for each cell and cannot hold labels");
    std::vector<int> result;
    result.reserve(cells.size());
    for (const double value : array.values) {
      if (!is_vtu_label(value)) {
        std::ostringstream text;
        text.precision(std::numeric_limits<double>::max_digits10);
        text << "the label of cell " << cells[result.size()] << " is not a 32-bit integer but "
             << value << "; correct the array " << in_quotes(array.name);
        m_reader.fail(text.str());
      }
      result.push_back(static_cast<int>(value));
    }
    return result;
  }

private:
  static bool may_be_labels(const Mesh_array& array) {
    return array.components == 1 &&
           std::all_of(array.values.begin(), array.values.end(), is_vtu_label);
  }

  std::size_t index_of(const std::string& name) const {
    const auto it = std::find_if(m_arrays.begin(), m_arrays.end(),
                                 [&](const Mesh_array& array) { return array.name == name; });
    return it == m_arrays.end() ? none : static_cast<std::size_t>(it - m_arrays.begin());
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw Label_array_error(m_reader.path() + ": " + what + "; " + description(), m_reader.path());
  }

  // Returns a description of all arrays, and advice how to choose one.
  std::string description() const {
    std::ostringstream text;
    text << (m_arrays.empty() ? "there are no cell arrays" : "there are ");
    for (const Mesh_array& array : m_arrays) {
      text << (&array == &m_arrays.front() ? "" : ", ") << in_quotes(array.name) << " ("
           << array.type;
      if (array.components != 1)
        text << ", " << array.components << " components";
      else if (!array.values.empty()) {
        const auto [least, largest] = std::minmax_element(array.values.begin(), array.values.end());
        text << (may_be_labels(array) ? ", integers" : ", not labels, values") << " from " << *least
             << " to " << *largest;
      }
      text << ')';
    }
    return text.str() +
           "; choose the array of labels by its name, or 'none' for label 1 everywhere";
  }

  const Vtu_reader& m_reader;
  const std::vector<Mesh_array>& m_arrays;
};

// The content of a VTU file with tetrahedra.
struct Vtu_tetrahedra
{
  std::vector<std::array<double, 3>> points;
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

// Merges equal points, and removes arrays whose values differ there.
inline void merge_points(Vtu_tetrahedra& mesh) {
  const Merged_corners merged(mesh.points, mesh.tetrahedra);
  if (!merged.has_repeated_points())
    return;
  mesh.points = merged.selected(mesh.points);
  std::vector<Mesh_array> kept;
  for (const Mesh_array& array : mesh.arrays.points)
    if (merged.agree(array.values, array.components))
      kept.push_back(array.selected(merged.rows()));
    else
      mesh.unused.add("point array with several values at a point (" + in_quotes(array.name) + ')');
  mesh.arrays.points.swap(kept);
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
  const std::vector<double> coordinates = reader.array("Points", "", number_of_points, 3);
  result.points.reserve(number_of_points);
  for (std::size_t i = 0; i < number_of_points; ++i) {
    result.points.push_back({coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]});
    if (!has_finite_coordinates(result.points.back()))
      reader.fail("a coordinate of point " + std::to_string(i) +
                  " is not a finite number; correct it");
  }
  result.tetrahedra =
      read_vtu_corners<std::size_t>(reader, cells, number_of_cells, number_of_points, 4);

  std::vector<Mesh_array>& on_cells = result.arrays.cells;
  result.arrays.points = read_vtu_arrays(reader, "PointData", number_of_points, result.unused);
  on_cells = read_vtu_arrays(reader, "CellData", number_of_cells, result.unused);
  if (cells.size() < number_of_cells)
    for (Mesh_array& array : on_cells)
      array = array.selected(cells);
  result.unused.add("arrays of field data", reader.number_of_global_arrays());
  result.arrays.label_names = reader.label_names();

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
  merge_points(result);
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_FILES_INTERNAL_GRIDS_READ_VTU_TETRAHEDRA_H
