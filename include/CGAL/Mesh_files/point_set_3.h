// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_POINT_SET_3_H
#define CGAL_MESH_FILES_POINT_SET_3_H

#include <CGAL/Mesh_files/File_error.h>
#include <CGAL/Mesh_files/Unused_content.h>
#include <CGAL/Mesh_files/internal/surfaces/Ply_reader.h>
#include <CGAL/Mesh_files/internal/surfaces/read_off.h>
#include <CGAL/Mesh_files/internal/text/File_scanner.h>
#include <CGAL/Mesh_files/internal/text/files.h>
#include <CGAL/Mesh_files/internal/text/number_of_word.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace CGAL {
namespace IO {

/// \ingroup PkgMeshFilesRef
/// Point of a surface and its normal, of any length; the normal is null if it is not known.
using Point_and_normal_3 = std::pair<Exact_predicates_inexact_constructions_kernel::Point_3,
                                     Exact_predicates_inexact_constructions_kernel::Vector_3>;

} // namespace IO

namespace Deformable_simplicial_complexes::internal {

// Receiver of the contents of a file that stores points and their normals, and records unused
// content.
struct Point_set_sink
{
  const File_scanner& file;
  Unused_content* not_used;
  std::vector<IO::Point_and_normal_3> points;
  std::size_t number_of_polygons = 0;

  void expect_points(std::size_t) {} // the announced number may be wrong

  void point(double x, double y, double z) {
    Progress_scope::check();
    if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
      file.fail("a coordinate of point " + std::to_string(points.size()) +
                " is not a finite number; correct it");
    points.push_back({{x, y, z}, NULL_VECTOR});
  }

  void normal(double x, double y, double z) { points.back().second = {x, y, z}; }
  void polygon(const std::vector<std::size_t>&) { ++number_of_polygons; }

  void unused(const std::string& kind, std::size_t number) {
    if (not_used)
      not_used->add(kind, number);
  }
};

// Returns the number of points in the first line if the line contains a single word that is such a
// number.
inline std::optional<std::size_t> read_number_of_points(File_scanner& scanner) {
  std::optional<std::size_t> result;
  if (scanner.next() && scanner.words_left() == 0)
    result = number_of_word<std::size_t>(scanner.word());
  if (!result)
    scanner.back();
  return result;
}

// Returns whether the fourth to sixth numbers of all points are colors: integers from 0 to 255,
// some of which are too large for components of unit normals.
inline bool are_colors(const std::vector<IO::Point_and_normal_3>& points) {
  constexpr double largest_color = 255;
  double largest = 0;
  for (const auto& [point, color] : points)
    for (int i = 0; i < 3; ++i) {
      if (color[i] < 0 || color[i] > largest_color || color[i] != std::trunc(color[i]))
        return false;
      largest = (std::max)(largest, color[i]);
    }
  return largest > 1;
}

// Uses the second half of the points as normals of the first half.
inline void take_second_half_as_normals(std::vector<IO::Point_and_normal_3>& points) {
  const std::size_t n = points.size() / 2;
  for (std::size_t i = 0; i < n; ++i)
    points[i].second = points[n + i].first - ORIGIN;
  points.resize(n);
}

// Reads a point from each line: three coordinates, and a normal if there are three more numbers.
// The first line may contain the number of points; then the normals may also follow after all
// points.
inline void read_xyz(File_scanner& scanner, Point_set_sink& sink) {
  const std::optional<std::size_t> announced = read_number_of_points(scanner);
  std::size_t normals = 0, lines_with_more = 0;
  while (scanner.next()) {
    scanner.back();
    const std::size_t line = scanner.line_number();
    std::vector<double> numbers;
    while (numbers.size() < 6 && scanner.next_on_line()) {
      scanner.back();
      numbers.push_back(scanner.number<double>());
    }
    if (numbers.size() < 3)
      scanner.fail("a point has fewer than three coordinates; correct it", line);
    sink.point(numbers[0], numbers[1], numbers[2]);
    if (numbers.size() == 6) {
      sink.normal(numbers[3], numbers[4], numbers[5]);
      ++normals;
    }
    lines_with_more += numbers.size() % 3 != 0 || scanner.words_left() > 0;
    scanner.skip_line();
  }
  sink.unused("lines with additional numbers", lines_with_more);
  std::vector<IO::Point_and_normal_3>& points = sink.points;
  if (announced && normals == 0 && points.size() == 2 * *announced)
    take_second_half_as_normals(points);
  if (announced && points.size() != *announced)
    scanner.fail("the first line announces " + std::to_string(*announced) + " points, but " +
                 std::to_string(points.size()) + " follow; is the file truncated?");
  if (are_colors(points)) {
    for (auto& [point, color] : points)
      color = NULL_VECTOR;
    sink.unused("colors of points", normals);
  }
}

} // namespace Deformable_simplicial_complexes::internal

namespace IO {

/*!
\ingroup PkgMeshFilesRef

Reads points, and their normals if the file has them, from a PLY file, an OFF file, or a text file
(any other extension, such as `.xyz` or `.pwn`). Polygons are not used. Linear in the size of the
file.

A line of a text file contains the three coordinates of a point, and optionally its normal. Other
numbers on a line are not used. If the fourth to sixth numbers of all points are integers from 0 to
255 and some are larger than 1, they are colors and not used. The first line may contain the number
of points; then the normals may also follow after all points.

\param path name of the file; the case of its extension does not matter
\param unused the unused content of the file is added to it, unless it is null: polygons, colors and
       other values of points. After an exception, a part of the unused content may have been added.
\return the points, in the order of the file

\throws Deformable_simplicial_complexes::File_error with the line if the file cannot be read, is
        malformed, has a coordinate that is not finite, has another number of points than announced,
        or has no points
*/
inline std::vector<Point_and_normal_3>
read_point_set(const std::string& path,
               Deformable_simplicial_complexes::Unused_content* unused = nullptr) {
  namespace internal = Deformable_simplicial_complexes::internal;
  using Deformable_simplicial_complexes::File_error;
  const std::string extension = internal::lower_case_extension(path);
  const Deformable_simplicial_complexes::Progress_phase phase("reading points");
  internal::Input_file in(path, extension);
  internal::File_scanner scanner(in, path);
  internal::Point_set_sink sink{scanner, unused, {}};
  if (extension == ".ply")
    internal::Ply_reader(scanner).read(sink);
  else if (extension == ".off")
    internal::read_off(scanner, sink);
  else
    internal::read_xyz(scanner, sink);
  sink.unused("polygons", sink.number_of_polygons);
  if (sink.points.empty())
    throw File_error(path + ": there are no points; choose a file with points", path);
  return std::move(sink.points);
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_MESH_FILES_POINT_SET_3_H
