// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_INTERNAL_SURFACES_PLY_READER_H
#define CGAL_MESH_FILES_INTERNAL_SURFACES_PLY_READER_H

#include <CGAL/Mesh_files/internal/text/File_scanner.h>
#include <CGAL/Mesh_files/internal/text/files.h>

#include <set>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A number type of the PLY format, with its two names. Every value of the type is exactly
// representable as `double`.
struct Ply_type
{
  const char* name;
  const char* sized_name;
  double (*read)(File_scanner&, Encoding);
};

template <class Number> double read_ply_number(File_scanner& scanner, Encoding encoding) {
  return static_cast<double>(scanner.number<Number>(encoding));
}

// Returns the number type with a given name, or null if there is none.
inline const Ply_type* find_ply_type(std::string_view name) {
  static constexpr Ply_type types[] = {{"char", "int8", read_ply_number<std::int8_t>},
                                       {"uchar", "uint8", read_ply_number<std::uint8_t>},
                                       {"short", "int16", read_ply_number<std::int16_t>},
                                       {"ushort", "uint16", read_ply_number<std::uint16_t>},
                                       {"int", "int32", read_ply_number<std::int32_t>},
                                       {"uint", "uint32", read_ply_number<std::uint32_t>},
                                       {"float", "float32", read_ply_number<float>},
                                       {"double", "float64", read_ply_number<double>}};
  for (const Ply_type& type : types)
    if (name == type.name || name == type.sized_name)
      return &type;
  return nullptr;
}

// A property of an element: a number, or a list of numbers if `size_type` is not null.
struct Ply_property
{
  enum Meaning { x, y, z, nx, ny, nz, corners, nothing };

  const Ply_type* size_type; // the type of the size of a list; null if the property is not a list
  const Ply_type* type;
  Meaning meaning;
  std::string name;
};

// An element of the header: a kind of item, the number of items, and their properties.
struct Ply_element
{
  enum Kind { point, polygon, other };

  Kind kind;
  std::string name;
  std::size_t number;
  std::vector<Ply_property> properties;

  bool has(Ply_property::Meaning meaning) const {
    for (const Ply_property& property : properties)
      if (property.meaning == meaning)
        return true;
    return false;
  }

  bool has_normal() const {
    return has(Ply_property::nx) && has(Ply_property::ny) && has(Ply_property::nz);
  }
};

// Returns the content of a property of points or polygons, as a noun in the plural for messages.
inline std::string ply_content(const std::string& name, Ply_element::Kind kind) {
  const std::string owners = kind == Ply_element::point ? " of points" : " of polygons";
  for (const char* color : {"red", "green", "blue", "alpha"})
    if (name == color || name == std::string("diffuse_") + color)
      return "colors" + owners;
  for (const char* coordinate : {"s", "t", "u", "v", "texture_u", "texture_v", "texcoord"})
    if (name == coordinate)
      return "texture coordinates" + owners;
  for (const char* coordinate : {"nx", "ny", "nz"})
    if (name == coordinate)
      return "normals" + owners;
  return "values " + in_quotes(name) + owners;
}

// A reader for PLY files, in text or binary form. It supports all number types of the format. It
// skips elements and properties that describe neither points nor polygons, and reports them as
// unused.
class Ply_reader
{
public:
  explicit Ply_reader(File_scanner& scanner) : m_scanner(scanner) { read_header(); }

  // Passes the points and the polygons to a sink; see read_polygons.h. Throws `File_error` if the
  // content contradicts the header.
  template <class Sink> void read(Sink& sink) {
    double coordinates[6] = {}; // of a point and its normal
    std::vector<std::size_t> corners;
    for (const Ply_element& element : m_elements) {
      if (element.kind == Ply_element::point)
        sink.expect_points(element.number);
      // Elements without properties occupy no bytes in the file.
      const std::size_t number = element.properties.empty() ? 0 : element.number;
      for (std::size_t i = 0; i < number; ++i) {
        for (const Ply_property& property : element.properties)
          if (property.meaning == Ply_property::corners)
            read_corners(property, corners);
          else if (property.meaning != Ply_property::nothing)
            coordinates[property.meaning] = property.type->read(m_scanner, m_encoding);
          else
            skip(property);
        if (element.kind == Ply_element::point) {
          sink.point(coordinates[0], coordinates[1], coordinates[2]);
          if (element.has_normal())
            sink.normal(coordinates[3], coordinates[4], coordinates[5]);
        } else if (element.kind == Ply_element::polygon)
          sink.polygon(corners);
        if (m_encoding == Encoding::text && m_scanner.words_left() > 0)
          m_scanner.fail("this line has more numbers than an element " + in_quotes(element.name) +
                         " has properties; correct it");
      }
    }
    report_unused(sink);
  }

private:
  // Returns the next word of the line. Throws `File_error` if there is none.
  std::string_view word() {
    if (!m_scanner.next_on_line())
      m_scanner.fail("a word is missing in the header; correct the header");
    return m_scanner.word();
  }

  const Ply_type* type() {
    const Ply_type* result = find_ply_type(word());
    if (!result)
      m_scanner.fail(in_quotes(m_scanner.word()) + " is not a number type; write int or double");
    return result;
  }

  void read_header() {
    if (!m_scanner.next() || m_scanner.word() != "ply")
      m_scanner.fail("the file does not begin with ply; is it a PLY file?");
    for (;;) {
      m_scanner.skip_line();
      if (!m_scanner.next())
        m_scanner.fail("the header does not end; is the file truncated?");
      if (m_scanner.word() == "format")
        read_format();
      else if (m_scanner.word() == "element")
        read_element();
      else if (m_scanner.word() == "property")
        read_property();
      else if (m_scanner.word() == "end_header")
        break;
      else if (m_scanner.word() != "comment" && m_scanner.word() != "obj_info")
        m_scanner.fail(in_quotes(m_scanner.word()) +
                       " is not a keyword of PLY headers; correct it");
    }
    m_scanner.skip_line();
    check_elements();
  }

  void read_format() {
    const std::string_view format = word();
    if (format == "binary_little_endian")
      m_encoding = Encoding::little_endian;
    else if (format == "binary_big_endian")
      m_encoding = Encoding::big_endian;
    else if (format != "ascii")
      m_scanner.fail(in_quotes(m_scanner.word()) + " is not a format of PLY files; write ascii");
  }

  void read_element() {
    const std::string_view name = word();
    const Ply_element::Kind kind = name == "vertex" || name == "vertices" ? Ply_element::point
                                   : name == "face" || name == "faces"    ? Ply_element::polygon
                                                                          : Ply_element::other;
    std::string element(name);
    if (element == "tristrips" || element == "range_grid")
      m_scanner.fail("the element " + in_quotes(element) +
                     " describes a surface without polygons; write the surface as polygons");
    m_elements.push_back({kind, std::move(element), m_scanner.number<std::size_t>(), {}});
  }

  void read_property() {
    if (m_elements.empty())
      m_scanner.fail("the property does not follow an element; correct the header");
    Ply_element& element = m_elements.back();
    const bool is_list = m_scanner.next_is("list");
    const Ply_type* const size_type = is_list ? type() : nullptr;
    const Ply_type* const number_type = type();
    const std::string_view name = word();
    Ply_property::Meaning meaning = Ply_property::nothing;
    if (element.kind == Ply_element::point && !is_list)
      meaning = name == "x"    ? Ply_property::x
                : name == "y"  ? Ply_property::y
                : name == "z"  ? Ply_property::z
                : name == "nx" ? Ply_property::nx
                : name == "ny" ? Ply_property::ny
                : name == "nz" ? Ply_property::nz
                               : Ply_property::nothing;
    if (element.kind == Ply_element::polygon && is_list &&
        (name == "vertex_indices" || name == "vertex_index"))
      meaning = Ply_property::corners;
    element.properties.push_back({size_type, number_type, meaning, std::string(name)});
  }

  void check_elements() const {
    for (const Ply_element& element : m_elements) {
      if (element.kind == Ply_element::point &&
          !(element.has(Ply_property::x) && element.has(Ply_property::y) &&
            element.has(Ply_property::z)))
        m_scanner.fail("points do not have the properties x, y and z; add them");
      if (element.kind == Ply_element::polygon && !element.has(Ply_property::corners))
        m_scanner.fail("polygons do not have the list vertex_indices; add it");
    }
  }

  // Reads the size of a list or an index. Throws `File_error` if it is not an integer from 0 to
  // 2^32 - 1.
  std::size_t index(const Ply_type& type) {
    const double number = type.read(m_scanner, m_encoding);
    if (!(number >= 0) || number != std::trunc(number) || number > 4294967295.)
      m_scanner.fail(
          "the size of a list or an index is not a number from 0 to 4294967295; correct it");
    return static_cast<std::size_t>(number);
  }

  void read_corners(const Ply_property& property, std::vector<std::size_t>& corners) {
    corners.clear();
    for (std::size_t n = index(*property.size_type); n > 0; --n)
      corners.push_back(index(*property.type));
  }

  void skip(const Ply_property& property) {
    for (std::size_t n = property.size_type ? index(*property.size_type) : 1; n > 0; --n)
      property.type->read(m_scanner, m_encoding);
  }

  // Reports all content that was not passed to the sink, including content after the last element.
  template <class Sink> void report_unused(Sink& sink) {
    for (const Ply_element& element : m_elements) {
      std::set<std::string> contents;
      for (const Ply_property& property : element.properties)
        if (element.kind != Ply_element::other &&
            (property.meaning == Ply_property::nothing ||
             (Ply_property::nx <= property.meaning && property.meaning <= Ply_property::nz &&
              !element.has_normal())))
          contents.insert(ply_content(property.name, element.kind));
      if (element.kind == Ply_element::other)
        contents.insert("elements " + in_quotes(element.name));
      for (const std::string& content : contents)
        sink.unused(content, element.number);
    }
    if (m_encoding != Encoding::text)
      return sink.unused("bytes after the last element", m_scanner.skip_all_bytes());
    if (m_scanner.next() && !m_scanner.is_keyword())
      m_scanner.fail("there are more numbers than the header announces; correct the header");
    m_scanner.back();
    sink.unused("lines after the last element", m_scanner.skip_all_lines());
  }

  File_scanner& m_scanner;
  Encoding m_encoding = Encoding::text;
  std::vector<Ply_element> m_elements;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_FILES_INTERNAL_SURFACES_PLY_READER_H
