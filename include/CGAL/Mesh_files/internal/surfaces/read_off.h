// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_INTERNAL_SURFACES_READ_OFF_H
#define CGAL_MESH_FILES_INTERNAL_SURFACES_READ_OFF_H

#include <CGAL/Mesh_files/internal/text/File_scanner.h>

#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The properties given by the first line of an OFF file.
struct Off_header
{
  bool has_texture, has_color, has_normal, is_homogeneous, has_dimension, has_edges;
  Encoding encoding;
};

// Reads the keyword, such as COFF BINARY. Numbers may follow the keyword without a space.
inline Off_header read_off_header(File_scanner& scanner) {
  std::string_view kind = scanner.next() ? scanner.word() : std::string_view();
  const auto has_prefix = [&](std::string_view prefix) {
    const bool is_there = kind.substr(0, prefix.size()) == prefix;
    if (is_there)
      kind.remove_prefix(prefix.size());
    return is_there;
  };
  Off_header header = {};
  header.has_texture = has_prefix("ST");
  header.has_color = has_prefix("C");
  header.has_normal = has_prefix("N");
  header.is_homogeneous = has_prefix("4");
  header.has_dimension = has_prefix("n");
  header.has_edges = has_prefix("OFF") || has_prefix("off");
  if ((!header.has_edges && !has_prefix("SKEL")) ||
      kind.find_first_not_of("0123456789") != kind.npos)
    scanner.fail("the file does not begin with OFF; is it an OFF file?");
  scanner.cut_word(scanner.word().size() - kind.size());
  const bool is_binary = scanner.next_is("BINARY");
  if (is_binary)
    scanner.skip_line();
  header.encoding = is_binary ? Encoding::big_endian : Encoding::text;
  return header;
}

// Returns a number of elements or an index. Throws `File_error` if it is negative.
inline std::size_t read_off_integer(File_scanner& scanner, Encoding encoding) {
  const auto n = scanner.template number<std::int32_t>(encoding);
  if (n < 0)
    scanner.fail("a number of elements or an index is negative; correct it");
  return static_cast<std::size_t>(n);
}

// Skips the number of edges. Some files omit it. In such a file the line with the other two numbers
// ends after them, and the next line has more than one number.
inline void skip_number_of_edges(File_scanner& scanner, Encoding encoding) {
  if (encoding == Encoding::text && scanner.words_left() == 0 && scanner.next()) {
    scanner.back();
    if (scanner.words_left() > 1)
      return;
  }
  read_off_integer(scanner, encoding);
}

// Passes the points and the polygons of an OFF file, in text or binary form, to a sink; see
// read_polygons.h. Throws `File_error` if the numbers contradict the header.
template <class Sink> void read_off(File_scanner& scanner, Sink& sink) {
  const Off_header header = read_off_header(scanner);
  const bool is_binary = header.encoding != Encoding::text;
  const auto integer = [&] { return read_off_integer(scanner, header.encoding); };
  const auto real = [&] {
    return is_binary ? double{scanner.template number<float>(header.encoding)}
                     : scanner.template number<double>();
  };
  // Skips the rest of an element. Returns whether the rest is not empty.
  const auto skip_rest = [&](std::size_t binary_reals) {
    const std::size_t n = is_binary ? binary_reals : scanner.words_left();
    if (is_binary)
      scanner.skip_bytes(sizeof(float) * n);
    else
      scanner.skip_line();
    return n > 0;
  };

  if (header.has_dimension && integer() != 3)
    scanner.fail("the dimension must be 3; choose a surface in space");
  const std::size_t number_of_points = integer(), number_of_polygons = integer();
  if (header.has_edges)
    skip_number_of_edges(scanner, header.encoding);
  sink.expect_points(number_of_points);
  std::size_t points_with_more = 0, polygons_with_more = 0;
  for (std::size_t i = 0; i < number_of_points; ++i) {
    const double x = real(), y = real(), z = real(), w = header.is_homogeneous ? real() : 1;
    sink.point(x / w, y / w, z / w);
    if (header.has_normal) {
      const double nx = real(), ny = real(), nz = real();
      sink.normal(nx, ny, nz);
    }
    points_with_more += skip_rest((header.has_color ? 4 : 0) + (header.has_texture ? 2 : 0));
  }
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < number_of_polygons; ++i) {
    corners.clear();
    for (std::size_t n = integer(); n > 0; --n)
      corners.push_back(integer());
    sink.polygon(corners);
    polygons_with_more += skip_rest(is_binary ? integer() : 0);
  }
  sink.unused(header.has_color && header.has_texture ? "colors and texture coordinates of points"
              : header.has_color                     ? "colors of points"
              : header.has_texture                   ? "texture coordinates of points"
                                                     : "points with additional numbers",
              points_with_more);
  sink.unused("colors of polygons", polygons_with_more);
  if (is_binary) {
    sink.unused("bytes after the last polygon", scanner.skip_all_bytes());
  } else {
    if (scanner.next() && !scanner.is_keyword())
      scanner.fail("the header announces " + std::to_string(number_of_points) + " points and " +
                   std::to_string(number_of_polygons) + " polygons, but more follow; correct it");
    scanner.back();
    sink.unused("lines after the last polygon", scanner.skip_all_lines());
  }
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_FILES_INTERNAL_SURFACES_READ_OFF_H
