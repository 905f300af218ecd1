// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_IO_READ_POLY_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_IO_READ_POLY_H

#include <CGAL/Deformable_simplicial_complex_2/Seeded_segments_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/text/File_scanner.h>
#include <CGAL/Deformable_simplicial_complexes/internal/text/files.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <limits>
#include <locale>
#include <string>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Reads segments, and seeds from regional attributes, in the format of Triangle (J. R. Shewchuk).
template <class Point> Seeded_segments_2<Point> read_poly(const std::string& path) {
  std::ifstream in(path);
  in.imbue(std::locale::classic());
  if (!in)
    throw File_error("cannot open " + path + ": check that it exists and may be read", path);
  File_scanner scanner(in, path);
  const auto coordinate = [&] {
    const double x = scanner.number<double>();
    if (!std::isfinite(x))
      scanner.fail("a coordinate is no finite number; correct it");
    return x;
  };
  const auto point = [&] {
    const double x = coordinate();
    return Point(x, coordinate());
  };
  Seeded_segments_2<Point> result;
  const std::size_t points = scanner.number<std::size_t>();
  if (scanner.number<std::size_t>() != 2)
    scanner.fail("the points are not in the plane: the second number has to be 2");
  scanner.skip_line();
  if (points == 0)
    scanner.fail("there are no points: those of a .node file have to be put into the file");
  std::size_t first = 0;
  for (std::size_t i = 0; i < points; ++i) {
    const std::size_t index = scanner.number<std::size_t>();
    if (i == 0 && index > 1)
      scanner.fail("the first point has neither the number 0 nor 1; correct it");
    if (i == 0)
      first = index;
    if (index != first + i)
      scanner.fail("the points are not numbered one after another; correct the numbers");
    result.points.push_back(point());
    scanner.skip_line();
  }
  const std::size_t segments = scanner.number<std::size_t>();
  scanner.skip_line();
  for (std::size_t i = 0; i < segments; ++i) {
    scanner.number<std::size_t>();
    std::array<std::size_t, 2> ends;
    for (std::size_t& end : ends) {
      end = scanner.number<std::size_t>() - first;
      if (end >= result.points.size())
        scanner.fail("a segment names a point that does not exist; correct it");
    }
    result.segments.push_back(ends);
    scanner.skip_line();
  }
  const auto seeds = [&](bool have_labels) {
    const std::size_t number = scanner.number<std::size_t>();
    scanner.skip_line();
    for (std::size_t i = 0; i < number; ++i) {
      scanner.number<std::size_t>();
      const Point p = point();
      double label = 0;
      if (have_labels)
        label = scanner.number<double>();
      if (label != std::floor(label) || label < (std::numeric_limits<int>::min)() ||
          label > (std::numeric_limits<int>::max)())
        scanner.fail("the attribute of a region is no integer that can be a label; correct it");
      result.seeds.emplace_back(p, int(label));
      scanner.skip_line();
    }
  };
  seeds(false);
  if (scanner.next()) {
    scanner.back();
    seeds(true);
  }
  return result;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_IO_READ_POLY_H
