// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IO_READ_OBJ_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IO_READ_OBJ_H

#include <CGAL/Deformable_simplicial_complexes/internal/text/File_scanner.h>
#include <CGAL/Deformable_simplicial_complexes/internal/text/files.h>
#include <CGAL/Deformable_simplicial_complexes/internal/text/number_of_word.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Hands the points and the polygons of an OBJ file to a sink; see read_polygons.h. Everything else
// in it is skipped.
template <class Sink> void read_obj(File_scanner& scanner, Sink& sink) {
  std::int64_t number_of_points = 0;
  // The first of the indices of a corner, as in 7/3/5: from 1, or back from the last point.
  const auto index_of_corner = [&] {
    const std::string_view corner = scanner.word();
    const auto index = number_of_word<std::int64_t>(corner.substr(0, corner.find('/')));
    if (!index || *index == 0 || *index < -number_of_points)
      scanner.fail(in_quotes(scanner.word()) + " is no corner of a polygon; correct it");
    return static_cast<std::size_t>(*index > 0 ? *index - 1 : number_of_points + *index);
  };

  std::vector<std::size_t> corners;
  while (scanner.next()) {
    if (scanner.word() == "v") {
      const double x = scanner.template number<double>(), y = scanner.template number<double>(),
                   z = scanner.template number<double>();
      sink.point(x, y, z);
      ++number_of_points;
    } else if (scanner.word() == "f") {
      corners.clear();
      while (scanner.next_on_line())
        corners.push_back(index_of_corner());
      sink.polygon(corners);
    } else if (!scanner.is_keyword())
      scanner.fail(in_quotes(scanner.word()) + " is not expected; is it an OBJ file?");
    scanner.skip_line();
  }
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IO_READ_OBJ_H
