// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IO_VTU_READER_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IO_VTU_READER_H

#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/internal/IO/base64.h>
#include <CGAL/Deformable_simplicial_complexes/internal/IO/files.h>
#include <CGAL/Deformable_simplicial_complexes/internal/IO/little_endian.h>
#include <CGAL/Deformable_simplicial_complexes/internal/IO/vtk_numbers.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// The arrays of a VTK unstructured grid of one piece. It is XML, in which numbers are text or
// base64, or refer to data appended to it: base64 again, or bytes, which make it no XML any more.
// Binary data begin with their size.
class Vtu_reader
{
public:
  explicit Vtu_reader(const std::string& path) : m_path(path) {
    std::string text = file_contents(path);
    cut_out_appended_data(text);
    std::istringstream xml(text);
    try {
      boost::property_tree::read_xml(xml, m_tree);
    } catch (const boost::property_tree::xml_parser_error& error) {
      fail("line " + std::to_string(error.line()) + ": " + error.message() +
           "; is it a VTK XML file, and whole?");
    }
    m_file = child(m_tree, "VTKFile");
    if (!m_file)
      fail("there is no element VTKFile; is it a VTK XML file?");
    const std::string type = attribute(*m_file, "type");
    if (type != "UnstructuredGrid")
      fail("the data set is of type '" + type + "'; write an UnstructuredGrid");
    const Tree* grid = child(*m_file, "UnstructuredGrid");
    if (!grid)
      fail("there is no element UnstructuredGrid; write the file again");
    if (grid->count("Piece") != 1)
      fail("there are " + std::to_string(grid->count("Piece")) +
           " pieces; write the grid as a single one");
    m_piece = child(*grid, "Piece");
  }
  Vtu_reader(const Vtu_reader&) = delete;
  Vtu_reader& operator=(const Vtu_reader&) = delete;

  std::size_t number_of_points() const { return number(*m_piece, "NumberOfPoints"); }
  std::size_t number_of_cells() const { return number(*m_piece, "NumberOfCells"); }

  bool has_array(const std::string& section, const std::string& name) const {
    return find(section, name) != nullptr;
  }

  // The numbers of an array, which must be `components` for each of `size` elements. An empty name
  // stands for the first array of the section.
  std::vector<double> array(const std::string& section, const std::string& name, std::size_t size,
                            std::size_t components = 1) const {
    const Tree* element = find(section, name);
    if (!element)
      fail("the section " + section + " has no array" + (name.empty() ? "" : " '" + name + "'") +
           "; write the grid again");
    const std::string known_as = "the array '" + attribute(*element, "Name") + "' of " + section;
    std::vector<double> result = numbers(*element, known_as);
    if (result.size() % components != 0 || result.size() / components != size)
      fail(known_as + " has " + std::to_string(result.size()) + " numbers and not " +
           (components == 1 ? "" : std::to_string(components) + " times ") + std::to_string(size) +
           "; is the file truncated?");
    return result;
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw File_error(m_path + ": " + what, m_path);
  }

private:
  using Tree = boost::property_tree::ptree;

  static const Tree* child(const Tree& element, const std::string& name) {
    const auto found = element.find(name);
    return found == element.not_found() ? nullptr : &found->second;
  }

  static std::string attribute(const Tree& element, const std::string& name) {
    const Tree* attributes = child(element, "<xmlattr>");
    const Tree* found = attributes ? child(*attributes, name) : nullptr;
    return found ? found->data() : std::string();
  }

  // An attribute that must be a number.
  std::size_t number(const Tree& element, const std::string& name) const {
    const std::string text = attribute(element, name);
    const char* end = text.data() + text.size();
    std::size_t result = 0;
    const auto [rest, error] = std::from_chars(text.data(), end, result);
    if (error != std::errc() || rest != end)
      fail("the attribute " + name + " should be a number, not '" + text + "'; correct it");
    return result;
  }

  const Tree* find(const std::string& section, const std::string& name) const {
    if (const Tree* arrays = child(*m_piece, section))
      for (const auto& [kind, element] : *arrays)
        if (kind == "DataArray" && (name.empty() || attribute(element, "Name") == name))
          return &element;
    return nullptr;
  }

  // Leaves the start and the end of the section, between which there may be any bytes.
  void cut_out_appended_data(std::string& text) {
    const std::size_t start = text.find("<AppendedData");
    if (start == std::string::npos)
      return;
    const std::size_t begin = text.find('>', start), end = text.rfind("</AppendedData>");
    if (begin == std::string::npos || end == std::string::npos || end <= begin)
      fail("the section AppendedData does not end; is the file truncated?");
    const std::size_t mark = text.find_first_not_of(" \t\r\n", begin + 1);
    if (text[mark] != '_')
      fail("the section AppendedData does not begin with '_'; write the file again");
    m_appended = text.substr(mark + 1, end - (mark + 1));
    text.erase(begin + 1, end - (begin + 1));
  }

  std::vector<double> numbers(const Tree& element, const std::string& known_as) const {
    const std::string format = attribute(element, "format");
    if (format == "ascii") {
      const std::optional<std::vector<double>> result = numbers_of_text(element.data());
      if (!result)
        fail(known_as + " has something that is no number; correct it");
      return *result;
    }
    if (format != "binary" && format != "appended")
      fail(known_as + " has the format '" + format + "'; write it as ascii, binary or appended");
    // Where numbers are text, compressor and byte order may be named but do not matter.
    if (!attribute(*m_file, "compressor").empty())
      fail("the numbers are compressed; write them as text or without compression, which is "
           "compressor type None in ParaView, SetCompressorTypeToNone() in VTK and "
           "compression=None in meshio");
    if (attribute(*m_file, "byte_order") == "BigEndian")
      fail("the numbers are big-endian; write them as text or as LittleEndian");

    const std::string type_name = attribute(element, "type");
    const Vtk_number_type* type = find_vtk_number_type(type_name);
    if (!type)
      fail(known_as + " has numbers of the unknown type '" + type_name +
           "'; write Int32 or Float64");
    const std::string bytes = format == "binary" ? block(element.data(), true, known_as)
                                                 : appended_block(element, known_as);
    if (bytes.size() % type->size != 0)
      fail(known_as + " ends within a number; write the file again");
    return type->numbers(bytes);
  }

  std::string appended_block(const Tree& element, const std::string& known_as) const {
    const std::size_t offset = number(element, "offset");
    if (offset > m_appended.size())
      fail(known_as + " begins behind the end of the data; is the file truncated?");
    const Tree* section = child(*m_file, "AppendedData");
    return block(std::string_view(m_appended).substr(offset),
                 !section || attribute(*section, "encoding") != "raw", known_as);
  }

  // What comes after its size in bytes.
  std::string block(std::string_view text, bool is_base64, const std::string& known_as) const {
    const auto first_bytes = [&](std::size_t n) {
      return is_base64 ? bytes_of_base64(text, n) : std::string(text.substr(0, n));
    };
    const std::string header_type = attribute(*m_file, "header_type");
    if (header_type != "" && header_type != "UInt32" && header_type != "UInt64")
      fail("the header_type '" + header_type + "' is unknown; write UInt32 or UInt64");
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
  Tree m_tree;
  const Tree* m_file = nullptr;
  const Tree* m_piece = nullptr;
  std::string m_appended;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IO_VTU_READER_H
