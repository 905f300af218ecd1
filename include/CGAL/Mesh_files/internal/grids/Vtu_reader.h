// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_INTERNAL_GRIDS_VTU_READER_H
#define CGAL_MESH_FILES_INTERNAL_GRIDS_VTU_READER_H

#include <CGAL/Mesh_files/File_error.h>
#include <CGAL/Mesh_files/Label_names.h>
#include <CGAL/Mesh_files/Mesh_arrays.h>
#include <CGAL/Mesh_files/internal/grids/vtk_numbers.h>
#include <CGAL/Mesh_files/internal/text/Xml_element.h>
#include <CGAL/Mesh_files/internal/text/files.h>
#include <CGAL/Mesh_files/internal/text/little_endian.h>
#include <CGAL/Mesh_files/internal/text/number_of_word.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the six bits of a character, or -1 if it is not a base64 digit.
inline int base64_digit(char c) {
  if ('A' <= c && c <= 'Z')
    return c - 'A';
  if ('a' <= c && c <= 'z')
    return c - 'a' + 26;
  if ('0' <= c && c <= '9')
    return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

// Returns the first bytes of a text in base64, at most `maximum`. Returns fewer bytes if the text
// ends or has an invalid character. Padding may occur anywhere, because some programs encode pieces
// one after the other.
inline std::string bytes_of_base64(std::string_view text, std::size_t maximum) {
  std::string bytes;
  std::uint32_t bits = 0;
  int number_of_bits = 0;
  for (const char c : text) {
    if (bytes.size() == maximum)
      break;
    if (c == ' ' || c == '\t' || c == '\r' || c == '\n')
      continue;
    if (c == '=') {
      number_of_bits = 0;
      continue;
    }
    const int digit = base64_digit(c);
    if (digit < 0)
      break;
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    number_of_bits += 6;
    if (number_of_bits >= 8) {
      number_of_bits -= 8;
      bytes += static_cast<char>(static_cast<unsigned char>(bits >> number_of_bits));
    }
  }
  return bytes;
}

// A reader for the arrays of a VTK unstructured grid with a single piece. The file is in XML.
// Numbers are stored in three ways: as text, in base64, or as references into appended data.
// Appended data are in base64 or raw; with raw data the file is not valid XML. A block of binary
// data begins with its size.
class Vtu_reader
{
public:
  explicit Vtu_reader(const std::string& path) : m_path(path), m_bytes(file_contents(path)) {
    cut_out_appended_data();
    const std::optional<Xml_element> file = child({"", "", m_xml}, "VTKFile");
    if (!file)
      fail("there is no element VTKFile; is it a VTK XML file?");
    m_file = *file;
    const std::string type = m_file.attribute("type");
    if (type != "UnstructuredGrid")
      fail("the data set is of type " + in_quotes(type) + "; write an UnstructuredGrid");
    const std::optional<Xml_element> grid = child(m_file, "UnstructuredGrid");
    if (!grid)
      fail("there is no element UnstructuredGrid; write the file again");
    m_grid = *grid;
    std::size_t number_of_pieces = 0;
    for_each_child(m_grid, "Piece", m_path, [&](const Xml_element& piece) {
      m_piece = piece;
      ++number_of_pieces;
    });
    if (number_of_pieces != 1)
      fail("there are " + std::to_string(number_of_pieces) +
           " pieces; write the grid as a single one");
  }
  Vtu_reader(const Vtu_reader&) = delete;
  Vtu_reader& operator=(const Vtu_reader&) = delete;

  std::size_t number_of_points() const { return number(m_piece, "NumberOfPoints"); }
  std::size_t number_of_cells() const { return number(m_piece, "NumberOfCells"); }

  // Returns the size of the file in bytes. A grid has at most this number of values, unless arrays
  // share data.
  std::size_t number_of_bytes() const { return (std::max)(m_bytes.size(), m_xml.size()); }

  // Returns the arrays that a section declares, without their values. Each name occurs once.
  std::vector<Mesh_array> announced_arrays(const std::string& section) const {
    std::vector<Mesh_array> result;
    for_each_array(section, [&](const Xml_element& element) {
      Mesh_array array{element.attribute("Name"), element.attribute("type"), 1, {}};
      if (!element.attribute("NumberOfComponents").empty())
        array.components = number(element, "NumberOfComponents");
      if (array.components == 0)
        fail("the array " + in_quotes(array.name) + " of " + section +
             " has no components; correct the attribute NumberOfComponents");
      if (std::none_of(result.begin(), result.end(),
                       [&](const Mesh_array& other) { return other.name == array.name; }))
        result.push_back(std::move(array));
    });
    return result;
  }

  // Returns the number of arrays with data of the whole grid, other than names of labels.
  std::size_t number_of_global_arrays() const {
    std::size_t result = 0;
    if (const std::optional<Xml_element> arrays = child(m_grid, "FieldData"))
      visit_xml(
          arrays->content, m_path, [&](const Xml_element&) { ++result; }, [](std::string_view) {});
    return label_names().empty() ? result : result - 2;
  }

  // Returns the names of labels, see Vtu_document::label_names(). Returns nothing if the field data
  // has no such arrays.
  Label_names label_names() const {
    const std::vector<double> labels = global_numbers("named_labels"),
                              bytes = global_numbers("label_names");
    Label_name_list result;
    std::string name;
    std::size_t number = 0;
    for (const double byte : bytes) {
      const double label = number < labels.size() ? labels[number] : .5;
      if (!(0 <= byte && byte <= 255) || std::abs(label) > (std::numeric_limits<int>::max)() ||
          label != std::trunc(label))
        return {};
      if (byte > 0) {
        name += static_cast<char>(static_cast<unsigned char>(byte));
        continue;
      }
      if (result.names.count(static_cast<int>(label)) > 0)
        return {};
      result.add(static_cast<int>(label), std::exchange(name, ""));
      ++number;
    }
    return name.empty() && number == labels.size() ? result.names : Label_names();
  }

  // Returns the values of an array. Throws `File_error` unless there are `components` values for
  // each of `size` elements. If the name is empty, the first array of the section is read.
  std::vector<double> array(const std::string& section, const std::string& name, std::size_t size,
                            std::size_t components = 1) const {
    const std::optional<Xml_element> element = find(section, name);
    if (!element)
      fail("the section " + section + " has no array" +
           (name.empty() ? "" : " " + in_quotes(name)) + "; write the grid again");
    const std::string known_as =
        "the array " + in_quotes(element->attribute("Name")) + " of " + section;
    std::vector<double> result = numbers(*element, known_as);
    if (result.size() % components != 0 || result.size() / components != size)
      fail(known_as + " has " + std::to_string(result.size()) + " numbers instead of " +
           (components == 1 ? "" : std::to_string(components) + " times ") + std::to_string(size) +
           "; is the file truncated?");
    return result;
  }

  const std::string& path() const { return m_path; }

  [[noreturn]] void fail(const std::string& what) const {
    throw File_error(m_path + ": " + what, m_path);
  }

private:
  // Returns the first child with a name.
  std::optional<Xml_element> child(const Xml_element& element, std::string_view name) const {
    std::optional<Xml_element> result;
    for_each_child(element, name, m_path, [&](const Xml_element& child) {
      if (!result)
        result = child;
    });
    return result;
  }

  // Returns the text of an element, without the text of its children.
  std::string text(const Xml_element& element) const {
    std::string result;
    visit_xml(
        element.content, m_path, [](const Xml_element&) {},
        [&](std::string_view part) { result += part; });
    return result;
  }

  // Returns the value of an attribute. Throws `File_error` if it is not a non-negative integer.
  std::size_t number(const Xml_element& element, const std::string& name) const {
    const std::string text = element.attribute(name);
    const std::optional<std::size_t> result = number_of_word<std::size_t>(text);
    if (!result)
      fail("the attribute " + name + " should be a number, not " + in_quotes(text) +
           "; correct it");
    return *result;
  }

  std::optional<Xml_element> find(const std::string& section, const std::string& name) const {
    std::optional<Xml_element> result;
    for_each_array(section, [&](const Xml_element& array) {
      if (!result && (name.empty() || array.attribute("Name") == name))
        result = array;
    });
    return result;
  }

  // Returns the numbers of an array with data of the whole grid; none if there is no such array.
  std::vector<double> global_numbers(const std::string& name) const {
    std::vector<double> result;
    if (const std::optional<Xml_element> arrays = child(m_grid, "FieldData"))
      for (const char* kind : {"DataArray", "Array"})
        for_each_child(*arrays, kind, m_path, [&](const Xml_element& array) {
          if (array.attribute("Name") == name)
            result = numbers(array, "the array " + in_quotes(name) + " of FieldData");
        });
    return result;
  }

  // Elements named "Array" contain strings.
  template <class Visit> void for_each_array(const std::string& section, const Visit& visit) const {
    if (const std::optional<Xml_element> arrays = child(m_piece, section))
      for (const char* kind : {"DataArray", "Array"})
        for_each_child(*arrays, kind, m_path, visit);
  }

  // Separates appended data, which may contain any bytes, from the XML text. The start tag and the
  // end tag of the section remain in the text.
  void cut_out_appended_data() {
    const std::size_t start = m_bytes.find("<AppendedData");
    if (start == std::string::npos)
      return m_xml.swap(m_bytes);
    const std::size_t begin = m_bytes.find('>', start), end = m_bytes.rfind("</AppendedData>");
    if (begin == std::string::npos || end == std::string::npos || end <= begin)
      fail("the section AppendedData does not end; is the file truncated?");
    const std::size_t mark = m_bytes.find_first_not_of(" \t\r\n", begin + 1);
    if (m_bytes[mark] != '_')
      fail("the section AppendedData does not begin with '_'; write the file again");
    m_appended = std::string_view(m_bytes).substr(mark + 1, end - (mark + 1));
    m_xml = m_bytes.substr(0, begin + 1) + m_bytes.substr(end);
  }

  std::vector<double> numbers(const Xml_element& element, const std::string& known_as) const {
    const std::string format = element.attribute("format");
    if (format == "ascii") {
      std::optional<std::vector<double>> result = numbers_of_text(text(element));
      if (!result)
        fail(known_as + " has a word that is not a number; correct it");
      return std::move(*result);
    }
    if (format != "binary" && format != "appended")
      fail(known_as + " has the format " + in_quotes(format) +
           "; write it as ascii, binary or appended");
    // For numbers as text, the attributes `compressor` and `byte_order` have no effect.
    if (!m_file.attribute("compressor").empty())
      fail("the numbers are compressed; write them as text or without compression, which is "
           "compressor type None in ParaView, SetCompressorTypeToNone() in VTK and "
           "compression=None in meshio");
    if (m_file.attribute("byte_order") == "BigEndian")
      fail("the numbers are big-endian; write them as text or as LittleEndian");

    std::string type_name = element.attribute("type");
    if (type_name == "String")
      type_name = "UInt8"; // bytes
    const Vtk_number_type* type = find_vtk_number_type(type_name);
    if (!type)
      fail(known_as + " has numbers of the unknown type " + in_quotes(type_name) +
           "; write Int32 or Float64");
    const std::string bytes = format == "binary" ? block(text(element), true, known_as)
                                                 : appended_block(element, known_as);
    if (bytes.size() % type->size != 0)
      fail(known_as + " ends within a number; write the file again");
    return type->numbers(bytes);
  }

  std::string appended_block(const Xml_element& element, const std::string& known_as) const {
    const std::size_t offset = number(element, "offset");
    if (offset > m_appended.size())
      fail(known_as + " begins after the end of the data; is the file truncated?");
    const std::optional<Xml_element> section = child(m_file, "AppendedData");
    return block(m_appended.substr(offset), !section || section->attribute("encoding") != "raw",
                 known_as);
  }

  // Returns the bytes of a block, without the size at its beginning.
  std::string block(std::string_view text, bool is_base64, const std::string& known_as) const {
    const auto first_bytes = [&](std::size_t n) {
      return is_base64 ? bytes_of_base64(text, n) : std::string(text.substr(0, n));
    };
    const std::string header_type = m_file.attribute("header_type");
    if (header_type != "" && header_type != "UInt32" && header_type != "UInt64")
      fail("the header_type " + in_quotes(header_type) + " is unknown; write UInt32 or UInt64");
    const std::size_t header_size = header_type == "UInt64" ? 8 : 4;
    const std::string header = first_bytes(header_size);
    if (header.size() == header_size) {
      const std::uint64_t size = header_size == 8 ? little_endian<std::uint64_t>(header.data())
                                                  : little_endian<std::uint32_t>(header.data());
      if (size <= text.size()) {
        std::string bytes = first_bytes(header_size + static_cast<std::size_t>(size));
        if (bytes.size() == header_size + size)
          return bytes.erase(0, header_size);
      }
    }
    fail(known_as + " ends too early; is the file truncated or damaged?");
  }

  std::string m_path;
  std::string m_bytes, m_xml; // All views refer to these strings.
  Xml_element m_file, m_grid, m_piece;
  std::string_view m_appended;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_FILES_INTERNAL_GRIDS_VTU_READER_H
