// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IO_POINT_SET_3_H
#define CGAL_IO_POINT_SET_3_H

#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/internal/IO/Ply_reader.h>
#include <CGAL/Deformable_simplicial_complexes/internal/IO/read_off.h>
#include <CGAL/Deformable_simplicial_complexes/internal/text/File_scanner.h>
#include <CGAL/Deformable_simplicial_complexes/internal/text/files.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {

namespace IO {

/// \ingroup PkgDeformableSimplicialComplex3Ref
/// A point and the normal of a surface there, of any length; null where it is not known.
using Point_and_normal_3 = std::pair<Exact_predicates_inexact_constructions_kernel::Point_3,
                                     Exact_predicates_inexact_constructions_kernel::Vector_3>;

} // namespace IO

namespace Deformable_simplicial_complexes {
namespace internal {

// Takes the points of a file and their normals.
struct Point_set_sink
{
  std::vector<IO::Point_and_normal_3> points;

  void expect_points(std::size_t) {} // a file may lie
  void point(double x, double y, double z) { points.push_back({{x, y, z}, NULL_VECTOR}); }
  void normal(double x, double y, double z) { points.back().second = {x, y, z}; }
  void polygon(const std::vector<std::size_t>&) {}
};

// A point on each line, by three numbers, and its normal, if there are three more. The first line
// may hold a single number, as of points.
inline void read_xyz(File_scanner& scanner, Point_set_sink& sink) {
  while (scanner.next()) {
    scanner.back();
    const std::size_t line = scanner.line_number();
    std::vector<double> numbers;
    while (numbers.size() < 6 && scanner.next_on_line()) {
      scanner.back();
      numbers.push_back(scanner.number<double>());
    }
    if (numbers.size() == 1 && sink.points.empty())
      continue;
    if (numbers.size() < 3)
      scanner.fail("a point has less than three coordinates; correct it", line);
    sink.point(numbers[0], numbers[1], numbers[2]);
    if (numbers.size() == 6)
      sink.normal(numbers[3], numbers[4], numbers[5]);
    scanner.skip_line();
  }
}

} // namespace internal
} // namespace Deformable_simplicial_complexes

namespace IO {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

reads points, and their normals if there are any: of a PLY or OFF file, whose polygons are passed
over, or else from lines of three or six numbers (`.xyz`, `.pwn`).

\param path is the name of the file, whose extension, in any case, tells the format
\return the points in the order of the file

\throws Deformable_simplicial_complexes::File_error with the line if the file cannot be read, has
        another form, or no points

Linear in the size of the file.
*/
inline std::vector<Point_and_normal_3> read_point_set(const std::string& path) {
  namespace internal = Deformable_simplicial_complexes::internal;
  using Deformable_simplicial_complexes::File_error;
  std::ifstream in(path, std::ios::binary);
  if (!in)
    throw File_error("cannot open " + path + ": check that it exists and may be read", path);
  internal::File_scanner scanner(in, path);
  internal::Point_set_sink sink;
  const std::string extension = internal::lower_case_extension(path);
  if (extension == ".ply")
    internal::Ply_reader(scanner).read(sink);
  else if (extension == ".off")
    internal::read_off(scanner, sink);
  else
    internal::read_xyz(scanner, sink);
  if (sink.points.empty())
    throw File_error(path + ": there are no points", path);
  return std::move(sink.points);
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_POINT_SET_3_H
