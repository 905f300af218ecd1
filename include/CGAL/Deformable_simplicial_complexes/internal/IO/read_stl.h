// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IO_READ_STL_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IO_READ_STL_H

#include <CGAL/Deformable_simplicial_complexes/internal/text/File_scanner.h>
#include <CGAL/Deformable_simplicial_complexes/internal/text/little_endian.h>

#include <cstddef>
#include <cstdint>
#include <ios>
#include <istream>
#include <string>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// A binary STL file is a header of 80 bytes, the number of triangles in four, and 50 for each.
constexpr std::size_t stl_header_size = 80;

// Whether the file has as many bytes as it says. Text has not: four characters are a number of
// triangles that take gigabytes.
inline bool is_binary_stl(std::istream& in) {
  char begin[stl_header_size + 4];
  const bool has_header = static_cast<bool>(in.read(begin, sizeof(begin)));
  in.clear();
  in.seekg(0, std::ios::end);
  const auto size = static_cast<std::uint64_t>(in.tellg());
  in.seekg(0);
  return has_header &&
         size >= sizeof(begin) +
                     50 * std::uint64_t{little_endian<std::uint32_t>(begin + stl_header_size)};
}

// Both hand the triangles and their corners to a sink; see read_polygons.h. Triangles share no
// points.

template <class Sink> void read_binary_stl(File_scanner& scanner, Sink& sink) {
  const auto real = [&] { return double{scanner.template number<float>(Encoding::little_endian)}; };
  scanner.skip_bytes(stl_header_size);
  const std::size_t n = scanner.template number<std::uint32_t>(Encoding::little_endian);
  sink.expect_points(3 * n);
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < n; ++i) {
    scanner.skip_bytes(3 * sizeof(float)); // the normal
    for (int j = 0; j < 3; ++j) {
      const double x = real(), y = real(), z = real();
      sink.point(x, y, z);
    }
    scanner.skip_bytes(sizeof(std::uint16_t)); // attributes
    corners = {3 * i, 3 * i + 1, 3 * i + 2};
    sink.polygon(corners);
  }
}

// Words that mean nothing, such as the names of solids, are skipped.
template <class Sink> void read_text_stl(File_scanner& scanner, Sink& sink) {
  std::size_t number_of_points = 0;
  std::vector<std::size_t> corners;
  const auto read_facet = [&] {
    corners.clear();
    while (scanner.next() && scanner.word() != "endfacet")
      if (scanner.word() == "vertex") {
        const double x = scanner.template number<double>(), y = scanner.template number<double>(),
                     z = scanner.template number<double>();
        sink.point(x, y, z);
        corners.push_back(number_of_points++);
      }
    if (corners.size() != 3)
      scanner.fail("a facet has " + std::to_string(corners.size()) +
                   " vertices; cut it into triangles");
    sink.polygon(corners);
  };

  bool is_whole = false;
  while (scanner.next())
    if (scanner.word() == "facet")
      read_facet();
    else if (scanner.word() == "solid")
      is_whole = false;
    else if (scanner.word() == "endsolid")
      is_whole = true;
  if (!is_whole)
    scanner.fail("the solid does not end; is it an STL file, and whole?");
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IO_READ_STL_H
