// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IO_READ_OFF_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IO_READ_OFF_H

#include <CGAL/Deformable_simplicial_complexes/internal/text/File_scanner.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Hands the points and the polygons of an OFF file, as text or binary, to a sink; see
// read_polygons.h. Colours and textures are skipped.
template <class Sink> void read_off(File_scanner& scanner, Sink& sink) {
  std::string kind(scanner.next() ? scanner.word() : "");
  const auto has_prefix = [&](std::string_view prefix) {
    const bool is_there = kind.compare(0, prefix.size(), prefix) == 0;
    if (is_there)
      kind.erase(0, prefix.size());
    return is_there;
  };
  const bool has_texture = has_prefix("ST"), has_color = has_prefix("C"),
             has_normal = has_prefix("N"), is_homogeneous = has_prefix("4"),
             has_dimension = has_prefix("n");
  if (kind != "OFF" && kind != "SKEL")
    scanner.fail("the file does not begin with OFF; is it an OFF file?");
  const bool is_binary = scanner.next_is("BINARY");
  if (is_binary)
    scanner.skip_line();

  const Encoding encoding = is_binary ? Encoding::big_endian : Encoding::text;
  const auto integer = [&] {
    const auto n = scanner.template number<std::int32_t>(encoding);
    if (n < 0)
      scanner.fail("a number of elements or an index is negative; correct it");
    return static_cast<std::size_t>(n);
  };
  const auto real = [&] {
    return is_binary ? double{scanner.template number<float>(encoding)}
                     : scanner.template number<double>();
  };
  const auto skip_reals = [&](std::size_t n) { scanner.skip_bytes(sizeof(float) * n); };

  if (has_dimension && integer() != 3)
    scanner.fail("the dimension must be 3; choose a surface in space");
  const std::size_t number_of_points = integer(), number_of_polygons = integer();
  if (kind == "OFF")
    integer(); // the number of edges
  sink.expect_points(number_of_points);
  for (std::size_t i = 0; i < number_of_points; ++i) {
    const double x = real(), y = real(), z = real(), w = is_homogeneous ? real() : 1;
    sink.point(x / w, y / w, z / w);
    if (has_normal) {
      const double nx = real(), ny = real(), nz = real();
      sink.normal(nx, ny, nz);
    }
    if (is_binary)
      skip_reals((has_color ? 4 : 0) + (has_texture ? 2 : 0));
    else
      scanner.skip_line();
  }
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < number_of_polygons; ++i) {
    corners.clear();
    for (std::size_t n = integer(); n > 0; --n)
      corners.push_back(integer());
    sink.polygon(corners);
    if (is_binary)
      skip_reals(integer()); // its colour
    else
      scanner.skip_line();
  }
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IO_READ_OFF_H
