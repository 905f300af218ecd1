// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/frame_of_vtu.h"

#include <CGAL/Mesh_files/internal/grids/read_vtu_tetrahedra.h>

namespace dsc {
namespace {

using DSC::internal::Vtu_reader;

/// Returns the number of vertices of the simplices of a grid.
/// \throws File_error if there are other cells than simplices of one dimension
std::size_t corners_of(const Vtu_reader& reader, std::size_t number_of_cells) {
  static constexpr std::array<std::pair<double, std::size_t>, 3> types = {
      {{3, 2}, {5, 3}, {10, 4}}};
  const std::vector<double> cells = reader.array("Cells", "types", number_of_cells);
  const auto type = std::find_if(types.begin(), types.end(), [&](const auto& known) {
    return !cells.empty() && known.first == cells.front();
  });
  if (type == types.end() ||
      std::any_of(cells.begin(), cells.end(), [&](double cell) { return cell != type->first; }))
    reader.fail("the cells are not tetrahedra, triangles or segments only; choose a file that dsc "
                "wrote");
  return type->second;
}

/// Returns whether the viewer computes this array, or does not need it.
bool is_known_array(const std::string& name) {
  return name == "label" || name == "label_pair" || name == "quality" || name == "boundary_class" ||
         name == "interface";
}

/// Adds the arrays of numbers that are scalars or vectors. An array of cells is left out if points
/// have an array of the same name, because a frame has one field of each name.
/// \pre arrays of points are added before arrays of cells
void add_fields(const Vtu_reader& reader, bool on_points, Read_frame& read) {
  const std::string section = on_points ? "PointData" : "CellData";
  const std::size_t rows = on_points ? read.frame.points.size() : read.frame.simplices.size();
  for (const DSC::Mesh_array& array : reader.announced_arrays(section)) {
    const bool is_added =
        std::any_of(read.frame.fields.begin(), read.frame.fields.end(),
                    [&](const Film_field& field) { return field.name == array.name; });
    if (is_added || is_known_array(array.name) || (array.components != 1 && array.components != 3))
      continue;
    Film_field field{
        array.name, on_points, array.components == 1 ? 1 : std::size_t(read.dimension), {}};
    const std::vector<double> values = reader.array(section, array.name, rows, array.components);
    for (std::size_t i = 0; i < values.size(); ++i)
      if (i % array.components < field.components)
        field.values.push_back(values[i]);
    if (!std::all_of(field.values.begin(), field.values.end(),
                     [](double x) { return std::isfinite(x); }))
      reader.fail("the array '" + array.name + "' of " + section +
                  " has a value that is not finite; correct or remove it");
    read.frame.fields.push_back(std::move(field));
  }
}

} // namespace

Read_frame frame_of_vtu(const std::string& path) {
  const Vtu_reader reader(path);
  const std::size_t cells = reader.number_of_cells(), points = reader.number_of_points();
  const std::vector<DSC::Mesh_array> arrays = reader.announced_arrays("CellData");
  const bool is_interface = std::any_of(arrays.begin(), arrays.end(), [](const auto& array) {
    return array.name == "label_pair" && array.components == 2;
  });
  Read_frame result;
  const std::size_t corners = cells == 0 ? 3 : corners_of(reader, cells);
  result.content = is_interface ? Film::Content::facets : Film::Content::cells;
  result.dimension = int(corners) - (is_interface ? 0 : 1);
  result.label_names = reader.label_names();
  Film_frame& frame = result.frame;
  const std::vector<double> coordinates = reader.array("Points", "", points, 3);
  for (std::size_t i = 0; i < coordinates.size(); i += 3)
    frame.points.push_back({coordinates[i], coordinates[i + 1], coordinates[i + 2]});
  std::vector<std::size_t> all(cells);
  std::iota(all.begin(), all.end(), std::size_t(0));
  frame.simplices =
      DSC::internal::read_vtu_corners<std::uint32_t>(reader, all, cells, points, corners);
  const std::vector<double> labels = is_interface ? reader.array("CellData", "label_pair", cells, 2)
                                                  : reader.array("CellData", "label", cells);
  if (!std::all_of(labels.begin(), labels.end(), DSC::internal::is_vtu_label))
    reader.fail("a label is not an integer of 32 bits; correct the array of the labels");
  for (std::size_t i = 0; i < cells; ++i)
    // The normals of a facet point out of the larger label, which is the first one in the file.
    frame.labels.push_back(is_interface
                               ? std::array<int, 2>{int(labels[2 * i + 1]), int(labels[2 * i])}
                               : std::array<int, 2>{int(labels[i]), 0});
  add_fields(reader, true, result);
  add_fields(reader, false, result);
  return result;
}

void leave_out(const std::vector<int>& labels, Read_frame& read) {
  const bool has_facets = read.content == Film::Content::facets;
  const std::size_t corners = std::size_t(read.dimension) + (has_facets ? 0 : 1);
  Film_frame& frame = read.frame;
  const auto is_left_out = [&](int label) {
    return std::find(labels.begin(), labels.end(), label) != labels.end();
  };
  std::vector<Index> simplices, points, place(frame.points.size(), none);
  for (std::size_t i = 0; i < frame.simplices.size(); ++i)
    if (!is_left_out(frame.labels[i][0]) || (has_facets && !is_left_out(frame.labels[i][1]))) {
      simplices.push_back(Index(i));
      for (std::size_t j = 0; j < corners; ++j)
        place[frame.simplices[i][j]] = 0; // is set below
    }
  for (std::size_t i = 0; i < place.size(); ++i)
    if (place[i] != none) {
      place[i] = Index(points.size());
      points.push_back(Index(i));
    }
  frame.points = chosen_rows(frame.points, points);
  frame.simplices = chosen_rows(frame.simplices, simplices);
  frame.labels = chosen_rows(frame.labels, simplices);
  for (auto& simplex : frame.simplices)
    for (std::size_t j = 0; j < corners; ++j)
      simplex[j] = place[simplex[j]];
  for (Film_field& field : frame.fields)
    field.values =
        chosen_rows(field.values, field.on_points ? points : simplices, field.components);
}

} // namespace dsc
