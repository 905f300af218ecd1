// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_IO_LABELLED_SURFACE_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_IO_LABELLED_SURFACE_3_H

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/Labelled_surface_3.h>
#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>
#include <CGAL/Deformable_simplicial_complexes/Unused_content.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/extract_interface_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/IO/read_polygons.h>
#include <CGAL/Deformable_simplicial_complexes/internal/IO/triangulated_polygon.h>
#include <CGAL/Deformable_simplicial_complexes/internal/text/File_scanner.h>
#include <CGAL/Deformable_simplicial_complexes/internal/text/files.h>
#include <CGAL/Deformable_simplicial_complexes/internal/text/open_input.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <ios>
#include <limits>
#include <numeric>
#include <ostream>
#include <string>
#include <system_error>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// By the extension of the file.
inline Surface_format surface_format(const std::string& path) {
  const std::string extension = lower_case_extension(path);
  return extension == ".off"   ? Surface_format::off
         : extension == ".obj" ? Surface_format::obj
         : extension == ".ply" ? Surface_format::ply
         : extension == ".stl" ? Surface_format::stl
                               : Surface_format::none;
}

// Takes the points of a file, counts what its polygons become, and notes what is not used.
template <class Point> struct Point_sink
{
  const File_scanner& file;
  std::size_t most_points; // that the file has space for
  Unused_content* not_used;
  std::vector<Point> points;
  std::size_t number_of_polygons = 0, number_of_triangles = 0, number_of_normals = 0;

  void expect_points(std::size_t n) {
    if (points.empty())
      points.reserve((std::min)(n, most_points));
  }

  void point(double x, double y, double z) {
    Progress_scope::check();
    if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
      file.fail("a coordinate of point " + std::to_string(points.size()) +
                " is not a finite number; correct it");
    points.emplace_back(x, y, z);
  }

  void normal(double, double, double) { ++number_of_normals; }

  void polygon(const std::vector<std::size_t>& corners) {
    if (corners.size() < 3)
      return unused("polygons with fewer than three corners", 1);
    ++number_of_polygons;
    number_of_triangles += corners.size() - 2;
  }

  void unused(const std::string& kind, std::size_t number) {
    if (not_used)
      not_used->add(kind, number);
  }
};

// Takes the triangles of polygons, whose points are known.
template <class Point> struct Triangle_sink
{
  const File_scanner& file;
  Labelled_surface_3<Point>& surface;
  std::vector<Point> points_of_polygon;
  std::size_t number_of_polygons = 0;

  void expect_points(std::size_t) {}
  void point(double, double, double) {}
  void normal(double, double, double) {}
  void unused(const std::string&, std::size_t) {}

  void polygon(const std::vector<std::size_t>& corners) {
    Progress_scope::check();
    points_of_polygon.clear();
    for (const std::size_t corner : corners) {
      if (corner >= surface.points.size())
        fail("refers to a point that is not there; repair the file");
      points_of_polygon.push_back(surface.points[corner]);
    }
    const auto triangles = triangulated_polygon(points_of_polygon);
    if (triangles.empty() && corners.size() >= 3)
      fail("cannot be triangulated; replace it by triangles");
    for (const auto& triangle : triangles)
      surface.triangles.push_back(
          {corners[triangle[0]], corners[triangle[1]], corners[triangle[2]]});
    ++number_of_polygons;
  }

  [[noreturn]] void fail(const std::string& what) const {
    file.fail("polygon " + std::to_string(number_of_polygons) + " " + what);
  }
};

// Returns the number of points that are corners of no triangle.
template <class Point>
std::size_t number_of_unused_points(const Labelled_surface_3<Point>& surface) {
  std::vector<bool> is_used(surface.points.size());
  for (const auto& triangle : surface.triangles)
    for (const std::size_t corner : triangle)
      is_used[corner] = true;
  return static_cast<std::size_t>(std::count(is_used.begin(), is_used.end(), false));
}

// Makes points with the same coordinates one, in the order in which they come first.
template <class Point> void merge_equal_points(Labelled_surface_3<Point>& surface) {
  std::vector<Point>& points = surface.points;
  std::vector<std::size_t> order(points.size()), place(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return points[a] == points[b] ? a < b : points[a] < points[b];
  });
  for (std::size_t i = 0, first = 0; i < order.size(); ++i) {
    if (points[order[i]] != points[order[first]])
      first = i;
    place[order[i]] = order[first];
  }
  std::size_t n = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (place[i] == i) {
      points[n] = points[i];
      place[i] = n++;
    } else
      place[i] = place[place[i]];
  points.resize(n);
  points.shrink_to_fit();
  for (auto& triangle : surface.triangles)
    for (auto& corner : triangle)
      corner = place[corner];
}

template <class Points, class Polygons>
bool write_soup(std::ostream& out, Surface_format format, const Points& points,
                const Polygons& polygons) {
  switch (format) {
  case Surface_format::off:
    return IO::write_OFF(out, points, polygons);
  case Surface_format::obj:
    return IO::write_OBJ(out, points, polygons);
  case Surface_format::ply:
    return IO::write_PLY(out, points, polygons);
  case Surface_format::stl:
    return IO::write_STL(out, points, polygons);
  case Surface_format::none:
    break;
  }
  return false;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes

namespace IO {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

reads a surface from a file in one of the formats OFF, OBJ, PLY and STL, chosen by the extension.

Polygons with more than three vertices are triangulated one by one. Polygons with more than four
vertices are projected along their normals, and their constrained Delaunay triangulations are used.
In STL files, where triangles share no points, points with the same coordinates become one. What the
surface looks like is not checked: `make_deformable_simplicial_complex_3()` does that.

Everything else in a file is noted in `unused`: colors, normals, texture coordinates, materials,
groups, names of solids if there are several, lines, other elements, points that no polygon has,
polygons with fewer than three corners. Facet normals of STL files are redundant and not noted.

\tparam Point is a point type of a \cgal kernel.

\param path is the name of the file.
\param label is the label of the solid that the surface bounds.
\param unused if not null, the content of the file that is not used is added to it. If an exception is
thrown, it may hold a part of that.

\throws Deformable_simplicial_complexes::File_error if the file cannot be opened or understood, has
no polygons or more elements than it announces, describes a part of the surface without polygons,
has a coordinate that is not finite, or has a polygon that refers to a point that is not there or
cannot be triangulated, as it meets itself.

Linear in the size of the file, for STL n log n. Memory is never taken for more points and triangles
than there are, however many the file announces.
*/
template <class Point = Exact_predicates_inexact_constructions_kernel::Point_3>
Deformable_simplicial_complexes::Labelled_surface_3<Point>
read_labelled_surface(const std::string& path, int label = 1,
                      Deformable_simplicial_complexes::Unused_content* unused = nullptr) {
  namespace internal = Deformable_simplicial_complexes::internal;
  const auto require = [&](bool condition, const char* message) {
    if (!condition)
      throw Deformable_simplicial_complexes::File_error(path + ": " + message, path);
  };
  const internal::Surface_format format = internal::surface_format(path);
  require(format != internal::Surface_format::none,
          "this is no format for surfaces; choose a file .off, .obj, .ply or .stl");
  const Deformable_simplicial_complexes::Progress_phase phase("reading a surface");
  std::ifstream in = internal::open_input(path, internal::lower_case_extension(path));
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  require(!error, "cannot read the file; check that it may be read");

  // Polygons may come before their points: first all of these, then all of those.
  constexpr std::size_t least_bytes_of_point = 3;
  internal::File_scanner first_scanner(in, path), second_scanner(in, path);
  internal::Point_sink<Point> points{
      first_scanner, static_cast<std::size_t>(size) / least_bytes_of_point, unused, {}};
  internal::read_polygons(in, format, first_scanner, points);
  points.unused("normals of points", points.number_of_normals);
  require(points.number_of_polygons != 0, "there are no polygons; choose a surface that has some");
  Deformable_simplicial_complexes::Labelled_surface_3<Point> surface;
  surface.label = label;
  surface.points.swap(points.points);
  surface.triangles.reserve(points.number_of_triangles);
  in.clear();
  in.seekg(0);
  internal::Triangle_sink<Point> triangles{second_scanner, surface, {}};
  internal::read_polygons(in, format, second_scanner, triangles);
  if (format == internal::Surface_format::stl)
    internal::merge_equal_points(surface);
  else if (unused)
    unused->add("points that no polygon has", internal::number_of_unused_points(surface));
  return surface;
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

writes an interface that was extracted, and may have been subdivided, to a file in one of the
formats OFF, OBJ, PLY and STL, chosen by the extension.

All of them are written as text in user coordinates with 17 significant digits; triangles come in
their order and keep their orientation. The file is written beside its final place and renamed when
complete.

\param path is the name of the file; its folder must exist.
\param surface is what `extract_interface()` or `subdivide_interface()` returned.

\throws Deformable_simplicial_complexes::File_error if the extension is none of these or the file
cannot be written; an older file of that name is unchanged then.
*/
template <class Complex>
void write_interface(const std::string& path,
                     const Deformable_simplicial_complexes::Interface_surface_3<Complex>& surface) {
  namespace internal = Deformable_simplicial_complexes::internal;
  const internal::Surface_format format = internal::surface_format(path);
  if (format == internal::Surface_format::none)
    throw Deformable_simplicial_complexes::File_error(
        path + " has no format for surfaces: choose .off, .obj, .ply or .stl", path);
  internal::replace_file_by_stream(path, [&](std::ostream& out) {
    out.precision(std::numeric_limits<double>::max_digits10);
    if (!internal::write_soup(out, format, surface.points, surface.triangles))
      out.setstate(std::ios::failbit);
  });
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

writes the whole interface to a file in one of the formats OFF, OBJ, PLY and STL, chosen by the
extension.

All of them are written as text in user coordinates with 17 significant digits; normals point out of
the larger label. The file is written beside its final place and renamed when complete.

\param path is the name of the file; its folder must exist.
\param dsc is the complex.

\throws Deformable_simplicial_complexes::File_error if the extension is none of these or the file
cannot be written; an older file of that name is unchanged then.

\sa `extract_interface()`
*/
template <class Traits, class Tds, class QualityMeasure>
void write_interface(const std::string& path,
                     const Deformable_simplicial_complex_3<Traits, Tds, QualityMeasure>& dsc) {
  write_interface(path, Deformable_simplicial_complexes::extract_interface(dsc));
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

writes the interface between two labels, with normals out of `a` into `b`; otherwise does as the
function for the whole interface.

\param path is the name of the file; its folder must exist.
\param dsc is the complex.
\param a, b are different labels.

\throws Deformable_simplicial_complexes::File_error as for the whole interface.
*/
template <class Traits, class Tds, class QualityMeasure>
void write_interface(
    const std::string& path,
    const Deformable_simplicial_complex_3<Traits, Tds, QualityMeasure>& dsc,
    typename Deformable_simplicial_complex_3<Traits, Tds, QualityMeasure>::Label a,
    typename Deformable_simplicial_complex_3<Traits, Tds, QualityMeasure>::Label b) {
  write_interface(path, Deformable_simplicial_complexes::extract_interface(dsc, a, b));
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_IO_LABELLED_SURFACE_3_H
