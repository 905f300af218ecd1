// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_INTERNAL_GRIDS_VTU_DOCUMENT_H
#define CGAL_MESH_FILES_INTERNAL_GRIDS_VTU_DOCUMENT_H

#include <CGAL/Mesh_files/Label_names.h>
#include <CGAL/Mesh_files/Mesh_arrays.h>
#include <CGAL/Mesh_files/internal/grids/vtk_numbers.h>
#include <CGAL/Mesh_files/internal/text/little_endian.h>

#include <ostream>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A VTK unstructured grid of simplices of one type, in XML with raw appended data. Each array is an
// XML element with the offset of a block of data. A block consists of its size in bytes and the
// values.
class Vtu_document
{
public:
  // the numbers used by VTK
  enum Cell_type : std::uint8_t { line = 3, triangle = 5, tetrahedron = 10 };

  Vtu_document(std::size_t number_of_points, std::size_t number_of_cells)
      : m_number_of_points(number_of_points), m_number_of_cells(number_of_cells) {}

  void begin(const std::string& section) { m_xml += "      <" + section + ">\n"; }
  void end(const std::string& section) { m_xml += "      </" + section + ">\n"; }

  template <class Number>
  void array(const std::string& name, const std::vector<Number>& values,
             std::size_t components = 1) {
    add_element(type_name<Number>(), name, components, values.size() * sizeof(Number));
    for (Number value : values)
      append_little_endian(m_data, value);
  }

  // Adds an array.
  // \pre The type is a number type of VTK and can represent the numbers.
  void array(const Mesh_array& array) {
    const std::string bytes = find_vtk_number_type(array.type)->bytes(array.values);
    add_element(array.type, array.name, array.components, bytes.size());
    m_data += bytes;
  }

  // Adds the names of labels as data of the whole grid: the array `named_labels`, and the array of
  // strings `label_names`, which are the codes of their bytes with a zero after each name.
  void label_names(const Label_names& names) {
    if (names.empty())
      return;
    const std::string form =
        "NumberOfTuples=\"" + std::to_string(names.size()) + "\" format=\"ascii\">";
    std::string labels, bytes;
    for (const auto& [label, name] : names) {
      labels += ' ' + std::to_string(label);
      for (const unsigned char c : name)
        bytes += ' ' + std::to_string(int(c));
      bytes += " 0";
    }
    m_field_data = "    <FieldData>\n      <DataArray type=\"Int32\" Name=\"named_labels\" " +
                   form + labels +
                   "</DataArray>\n      <Array type=\"String\" Name=\"label_names\" " + form +
                   bytes + "</Array>\n    </FieldData>\n";
  }

  // Adds the section with the coordinates. Points of the plane get the third coordinate 0.
  template <class Point> void points(const std::vector<Point>& points) {
    std::vector<double> coordinates;
    coordinates.reserve(3 * points.size());
    for (const Point& p : points)
      for (int i = 0; i < 3; ++i)
        coordinates.push_back(i < p.dimension() ? p[i] : 0.);
    begin("Points");
    array("points", coordinates, 3);
    end("Points");
  }

  // Adds the section with the vertices of the cells.
  void cells(const std::vector<std::int64_t>& connectivity, Cell_type type) {
    std::vector<std::int64_t> offsets(m_number_of_cells);
    for (std::size_t i = 0; i < offsets.size(); ++i)
      offsets[i] = std::int64_t((i + 1) * (connectivity.size() / m_number_of_cells));
    begin("Cells");
    array("connectivity", connectivity);
    array("offsets", offsets);
    array("types", std::vector<std::uint8_t>(m_number_of_cells, type));
    end("Cells");
  }

  void write(std::ostream& out) const {
    out << "<?xml version=\"1.0\"?>\n"
           "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
           "header_type=\"UInt64\">\n"
           "  <UnstructuredGrid>\n"
        << m_field_data << "    <Piece NumberOfPoints=\"" << m_number_of_points
        << "\" NumberOfCells=\"" << m_number_of_cells << "\">\n"
        << m_xml
        << "    </Piece>\n"
           "  </UnstructuredGrid>\n"
           "  <AppendedData encoding=\"raw\">\n"
           "_"
        << m_data
        << "\n"
           "  </AppendedData>\n"
           "</VTKFile>\n";
  }

private:
  // Adds the element of an array of `size` bytes. The caller appends the bytes.
  void add_element(const std::string& type, const std::string& name, std::size_t components,
                   std::size_t size) {
    m_xml += "        <DataArray type=\"" + type + "\" Name=\"" + name +
             "\" NumberOfComponents=\"" + std::to_string(components) +
             "\" format=\"appended\" offset=\"" + std::to_string(m_data.size()) + "\"/>\n";
    append_little_endian(m_data, std::uint64_t(size));
  }

  template <class Number> static std::string type_name() {
    const char* kind = std::is_floating_point<Number>::value ? "Float"
                       : std::is_signed<Number>::value       ? "Int"
                                                             : "UInt";
    return kind + std::to_string(8 * sizeof(Number));
  }

  std::size_t m_number_of_points, m_number_of_cells;
  std::string m_field_data, m_xml;
  std::string m_data;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_FILES_INTERNAL_GRIDS_VTU_DOCUMENT_H
