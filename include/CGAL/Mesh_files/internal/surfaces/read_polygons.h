// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_INTERNAL_SURFACES_READ_POLYGONS_H
#define CGAL_MESH_FILES_INTERNAL_SURFACES_READ_POLYGONS_H

#include <CGAL/Mesh_files/File_error.h>
#include <CGAL/Mesh_files/internal/surfaces/Ply_reader.h>
#include <CGAL/Mesh_files/internal/surfaces/read_off.h>
#include <CGAL/Mesh_files/internal/text/File_scanner.h>
#include <CGAL/Mesh_files/internal/text/files.h>
#include <CGAL/Mesh_files/internal/text/little_endian.h>
#include <CGAL/Mesh_files/internal/text/number_of_word.h>

#include <map>

namespace CGAL::Deformable_simplicial_complexes::internal {

// What a name of a part belongs to: an object of an OBJ file or a solid of an STL file, or a group
// of an OBJ file.
enum class Part_kind { object, group };

// A statement of an OBJ file that gives neither a point nor a polygon.
struct Obj_statement
{
  std::string_view keyword;
  const char* content; // the name of the unused content; null if the statement describes a surface
};

// Returns null if the keyword is unknown.
inline const Obj_statement* find_obj_statement(std::string_view keyword) {
  static constexpr Obj_statement statements[] = {{"vt", "texture coordinates"},
                                                 {"vn", "normals"},
                                                 {"vp", "points in parameter space"},
                                                 {"s", "smoothing groups"},
                                                 {"mg", "merging groups"},
                                                 {"usemtl", "materials of polygons"},
                                                 {"mtllib", "material files"},
                                                 {"usemap", "textures of polygons"},
                                                 {"maplib", "texture files"},
                                                 {"p", "point elements"},
                                                 {"l", "lines"},
                                                 {"curv", "curves"},
                                                 {"curv2", "curves"},
                                                 {"surf", nullptr},
                                                 {"bzp", nullptr},
                                                 {"bsp", nullptr},
                                                 {"cdp", nullptr},
                                                 {"call", nullptr}};
  for (const Obj_statement& statement : statements)
    if (statement.keyword == keyword)
      return &statement;
  return nullptr;
}

// Passes the points and the polygons of an OBJ file to a sink; see read_polygons.h. Throws
// `File_error` if a statement is invalid, or describes a surface without polygons.
template <class Sink> void read_obj(File_scanner& scanner, Sink& sink) {
  std::int64_t number_of_points = 0;
  // Returns the zero-based point index of a corner. A corner such as 7/3/5 has up to three indices,
  // and the first one is the index of the point. Positive indices begin with 1; negative ones count
  // back from the last point.
  const auto index_of_corner = [&] {
    const std::string_view corner = scanner.word();
    const auto index = number_of_word<std::int64_t>(corner.substr(0, corner.find('/')));
    if (!index || *index == 0 || *index < -number_of_points)
      scanner.fail(in_quotes(scanner.word()) + " is not a corner of a polygon; correct it");
    return static_cast<std::size_t>(*index > 0 ? *index - 1 : number_of_points + *index);
  };

  std::size_t weights = 0, colors = 0;
  std::map<std::string, std::size_t> unused;
  std::vector<std::size_t> corners;
  scanner.continue_lines_at('\\');
  while (scanner.next()) {
    const std::string_view keyword = scanner.word();
    if (keyword == "v") {
      const double x = scanner.template number<double>(), y = scanner.template number<double>(),
                   z = scanner.template number<double>();
      sink.point(x, y, z);
      ++number_of_points;
      weights += scanner.words_left() == 1;
      colors += scanner.words_left() > 1;
    } else if (keyword == "f" || keyword == "fo") {
      corners.clear();
      while (scanner.next_on_line())
        corners.push_back(index_of_corner());
      sink.polygon(corners);
    } else if (keyword == "o" || keyword == "g") {
      const Part_kind kind = keyword == "o" ? Part_kind::object : Part_kind::group;
      sink.part(kind, scanner.rest_of_line()); // names like part #2 are usual
    } else if (!scanner.is_keyword()) {
      scanner.fail(in_quotes(keyword) + " is not expected; is it an OBJ file?");
    } else if (const Obj_statement* const statement = find_obj_statement(keyword)) {
      if (!statement->content)
        scanner.fail(in_quotes(keyword) + " describes a surface without polygons or in another "
                                          "file; write the surface as polygons");
      ++unused[statement->content];
    } else {
      // A message names at most this number of unknown statements.
      constexpr std::size_t most_kinds = 40;
      ++unused[unused.size() < most_kinds ? "statements " + in_quotes(keyword)
                                          : "other statements"];
    }
    scanner.skip_line();
  }
  sink.unused("weights of points", weights);
  sink.unused("colors of points", colors);
  for (const auto& [content, number] : unused)
    sink.unused(content, number);
}

// A binary STL file consists of a header of 80 bytes, the number of triangles in four bytes, and 50
// bytes for each triangle.
constexpr std::size_t stl_header_size = 80, stl_triangle_size = 50;

// Returns whether an STL file is binary. It is binary if it has at least the announced number of
// bytes, or if its first 84 bytes contain a null character. In a text file, the four bytes at the
// position of the number are characters. They would announce gigabytes of triangles, more than the
// file contains. The word "solid" is not tested, because headers of binary files may begin with it,
// too.
//
// Throws `File_error` if a binary file is truncated, or has more triangles than announced.
inline bool is_binary_stl(std::istream& in, const std::string& path) {
  std::string begin(stl_header_size + sizeof(std::uint32_t), '\0');
  in.read(&begin[0], static_cast<std::streamsize>(begin.size()));
  const auto begin_size = static_cast<std::size_t>(in.gcount());
  in.clear();
  in.seekg(0, std::ios::end);
  const auto size = static_cast<std::uint64_t>(in.tellg());
  in.seekg(0);
  if (begin_size < begin.size())
    return false;
  const std::uint64_t n = little_endian<std::uint32_t>(begin.data() + stl_header_size);
  const std::uint64_t announced = begin.size() + stl_triangle_size * n;
  const auto fail = [&](const std::string& what) {
    throw File_error(path + ": the file announces " + std::to_string(n) + " triangles and " + what,
                     path);
  };
  if (size >= announced) {
    const std::uint64_t rest = size - announced;
    if (rest > 0 && rest % stl_triangle_size == 0)
      fail("has bytes for " + std::to_string(n + rest / stl_triangle_size) +
           "; correct the number in the header");
    return true;
  }
  if (begin.find('\0') == begin.npos)
    return false;
  fail("lacks their last " + std::to_string(announced - size) +
       " bytes; is it a complete STL file?");
  return true;
}

// Passes the triangles and their corners to a sink; see read_polygons.h. Triangles share no points.
// Stored normals are skipped, since the corners determine them.

template <class Sink> void read_binary_stl(File_scanner& scanner, Sink& sink) {
  const auto real = [&] { return double{scanner.template number<float>(Encoding::little_endian)}; };
  scanner.skip_bytes(stl_header_size);
  const std::size_t n = scanner.template number<std::uint32_t>(Encoding::little_endian);
  sink.expect_points(3 * n);
  std::size_t attributes = 0;
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < n; ++i) {
    scanner.skip_bytes(3 * sizeof(float)); // the normal
    for (int j = 0; j < 3; ++j) {
      const double x = real(), y = real(), z = real();
      sink.point(x, y, z);
    }
    attributes += scanner.template number<std::uint16_t>(Encoding::little_endian) != 0;
    corners = {3 * i, 3 * i + 1, 3 * i + 2};
    sink.polygon(corners);
  }
  sink.unused("attributes of triangles", attributes);
  sink.unused("bytes after the last triangle", scanner.skip_all_bytes());
}

// A reader for STL files in text form. Like `read_binary_stl()`, it passes triangles and their
// corners to a sink. Upper and lower case are equivalent in keywords.
template <class Sink> class Stl_text_reader
{
public:
  Stl_text_reader(File_scanner& scanner, Sink& sink) : m_scanner(scanner), m_sink(sink) {}

  void read() {
    bool is_in_solid = false;
    std::size_t solids = 0, others = 0;
    while (m_scanner.next()) {
      if (is("solid") || is("endsolid")) {
        is_in_solid = is("solid");
        solids += is_in_solid;
        read_name(is_in_solid);
      } else if (solids == 0) {
        m_scanner.fail("the file does not begin with solid; is it an STL file?");
      } else if (is("facet")) {
        read_facet();
      } else {
        ++others;
        m_scanner.skip_line();
      }
    }
    if (is_in_solid || solids == 0)
      m_scanner.fail("the solid does not end; is it a complete STL file?");
    m_sink.unused("lines outside facets", others);
  }

private:
  // Returns whether the word equals a keyword, regardless of case. The keyword is given in lower
  // case.
  bool is(std::string_view expected) const {
    const std::string_view word = m_scanner.word();
    return std::equal(word.begin(), word.end(), expected.begin(), expected.end(),
                      [](char a, char b) { return a == b || a == b - 'a' + 'A'; });
  }

  // Reads the name of a solid. It ends at the end of the line or before a facet.
  void read_name(bool begins_solid) {
    std::string name;
    bool is_before_facet = false;
    while (!is_before_facet && m_scanner.next_on_line()) {
      const std::string word(m_scanner.word());
      if (is("facet") && m_scanner.next_on_line()) {
        is_before_facet = is("normal");
        if (!is_before_facet)
          m_scanner.back();
      }
      if (!is_before_facet)
        name.append(name.empty() ? "" : " ").append(word);
    }
    if (begins_solid)
      m_sink.part(Part_kind::object, is_before_facet ? name : name + m_scanner.comment());
    if (is_before_facet)
      read_facet();
  }

  void read_facet() {
    const std::size_t line = m_scanner.line_number();
    m_corners.clear();
    bool is_whole = false;
    while (!is_whole && m_scanner.next()) {
      is_whole = is("endfacet");
      if (is("vertex")) {
        const double x = m_scanner.template number<double>(),
                     y = m_scanner.template number<double>(),
                     z = m_scanner.template number<double>();
        m_sink.point(x, y, z);
        m_corners.push_back(m_number_of_points++);
      }
    }
    if (!is_whole)
      m_scanner.fail("this facet does not end; is the file truncated?", line);
    if (m_corners.size() != 3)
      m_scanner.fail("a facet has " + std::to_string(m_corners.size()) +
                     " vertices; cut it into triangles");
    m_sink.polygon(m_corners);
  }

  File_scanner& m_scanner;
  Sink& m_sink;
  std::size_t m_number_of_points = 0;
  std::vector<std::size_t> m_corners;
};

enum class Surface_format { none, off, obj, ply, stl };

// Reads a surface file and passes its content to `sink`, in the order of the file:
// - `expect_points(n)`: the number of points, if the file gives it; it may be wrong;
// - `point(x, y, z)`: a point; coordinates may be infinite or NaN;
// - `normal(x, y, z)`: the normal of the last point, if the file gives it;
// - `polygon(corners)`: the indices of the corners, a `std::vector<std::size_t>`. A polygon may
//   come before its points, and its indices may be wrong;
// - `part(kind, name)`: the name of the part to which the next polygons belong; may be empty;
// - `unused(kind, number)`: content that is not passed, reported at the end.
//
// Stores only the current polygon. Throws `File_error` with the line if the file is invalid.
// \pre `format` is not `none`, and `scanner` is at the beginning of the file that `in` reads.
template <class Sink>
void read_polygons(std::istream& in, Surface_format format, File_scanner& scanner, Sink& sink) {
  switch (format) {
  case Surface_format::off:
    return read_off(scanner, sink);
  case Surface_format::obj:
    return read_obj(scanner, sink);
  case Surface_format::ply:
    return Ply_reader(scanner).read(sink);
  case Surface_format::stl:
    return is_binary_stl(in, scanner.path()) ? read_binary_stl(scanner, sink)
                                             : Stl_text_reader<Sink>(scanner, sink).read();
  case Surface_format::none:
    break;
  }
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_FILES_INTERNAL_SURFACES_READ_POLYGONS_H
