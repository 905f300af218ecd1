// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IO_LABELLED_SURFACE_3_H
#define CGAL_IO_LABELLED_SURFACE_3_H

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3/Labelled_surface_3.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/internal/IO/files.h>
#include <CGAL/extract_interface_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <fstream>
#include <ios>
#include <istream>
#include <limits>
#include <locale>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// The triangles of a polygon as places in it; empty if it cannot be triangulated.
template <class Point>
std::vector<std::array<std::size_t, 3>> triangulated_polygon(const std::vector<Point>& corners) {
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Mesh = Surface_mesh<Kernel::Point_3>;
  std::vector<std::array<std::size_t, 3>> triangles;
  if (corners.size() == 3)
    triangles.push_back({0, 1, 2});
  if (corners.size() <= 3)
    return triangles;

  // Of unit size, so that products neither overflow nor vanish.
  const auto from_first_corner = [&](const Point& p) {
    return Kernel::Vector_3(to_double(p.x()) - to_double(corners[0].x()),
                            to_double(p.y()) - to_double(corners[0].y()),
                            to_double(p.z()) - to_double(corners[0].z()));
  };
  double size = 0;
  for (const Point& p : corners)
    for (int i = 0; i < 3; ++i)
      size += std::abs(from_first_corner(p)[i]);
  if (!std::isfinite(size) || size == 0)
    return triangles;

  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  for (const Point& p : corners)
    vertices.push_back(mesh.add_vertex(ORIGIN + from_first_corner(p) / size));
  const auto polygon = mesh.add_face(vertices);
  if (!Polygon_mesh_processing::triangulate_face(polygon, mesh))
    return triangles;
  for (const auto face : mesh.faces()) {
    std::array<std::size_t, 3> triangle;
    auto corner = triangle.begin();
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(face)))
      *corner++ = v.idx();
    triangles.push_back(triangle);
  }
  return triangles;
}

enum class Surface_format { none, off, obj, ply, stl };

// By the extension of the file.
inline Surface_format surface_format(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension)
    c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return extension == ".off"   ? Surface_format::off
         : extension == ".obj" ? Surface_format::obj
         : extension == ".ply" ? Surface_format::ply
         : extension == ".stl" ? Surface_format::stl
                               : Surface_format::none;
}

// CGAL reads lines with streams of its own.
inline bool has_classic_numbers(const std::locale& locale) {
  const auto& numbers = std::use_facet<std::numpunct<char>>(locale);
  return numbers.decimal_point() == '.' && numbers.grouping().empty();
}

template <class Points, class Polygons>
bool read_soup(std::istream& in, Surface_format format, Points& points, Polygons& polygons) {
  switch (format) {
  case Surface_format::off:
    return IO::read_OFF(in, points, polygons);
  case Surface_format::obj:
    return IO::read_OBJ(in, points, polygons);
  case Surface_format::ply:
    return IO::read_PLY(in, points, polygons);
  case Surface_format::stl:
    return IO::read_STL(in, points, polygons);
  case Surface_format::none:
    break;
  }
  return false;
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

template <class Complex>
void write_surface(const std::string& path, const Interface_surface_3<Complex>& surface) {
  const Surface_format format = surface_format(path);
  if (format == Surface_format::none)
    throw File_error(path + " has no format for surfaces: choose .off, .obj, .ply or .stl", path);
  replace_file_by_stream(path, [&](std::ostream& out) {
    out.precision(std::numeric_limits<double>::max_digits10);
    if (!write_soup(out, format, surface.points, surface.triangles))
      out.setstate(std::ios::failbit);
  });
}

} // namespace internal
} // namespace Deformable_simplicial_complexes

namespace IO {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

reads a surface from a file in one of the formats OFF, OBJ, PLY and STL, chosen by the extension.

Polygons with more than three vertices are triangulated one by one, with
`Polygon_mesh_processing::triangulate_face()`. In STL files, where triangles share no points,
points with the same coordinates become one. What the surface looks like is not checked:
`make_deformable_simplicial_complex_3()` does that.

\tparam Point is a point type of a \cgal kernel.

\param path is the name of the file.
\param label is the label of the solid that the surface bounds.

\throws Deformable_simplicial_complexes::File_error if the file cannot be opened or understood, has
no polygons, or has a polygon that refers to a point that is not there or cannot be triangulated;
also if the global locale does not write numbers as the classic one does.

Linear in the size of the file, for STL n log n.
*/
template <class Point = Exact_predicates_inexact_constructions_kernel::Point_3>
Labelled_surface_3<Point> read_labelled_surface(const std::string& path, int label = 1) {
  namespace internal = Deformable_simplicial_complexes::internal;
  const auto require = [&](bool condition, const char* message) {
    if (!condition)
      throw Deformable_simplicial_complexes::File_error(path + ": " + message, path);
  };
  const internal::Surface_format format = internal::surface_format(path);
  require(format != internal::Surface_format::none,
          "this is no format for surfaces; choose a file .off, .obj, .ply or .stl");
  require(internal::has_classic_numbers(std::locale()),
          "the global locale writes numbers in another way than the file; set it to "
          "std::locale::classic()");
  std::ifstream in(path, std::ios::binary);
  require(in.good(), "cannot open the file; check that it exists and may be read");

  Labelled_surface_3<Point> surface;
  surface.label = label;
  std::vector<std::vector<std::size_t>> polygons;
  bool is_read = false;
  try {
    is_read = internal::read_soup(in, format, surface.points, polygons);
  } catch (const std::exception&) { // sizes that no memory suffices for
  }
  require(is_read && !polygons.empty(),
          "cannot find a surface; check that the file is whole and in the format of its extension");

  std::vector<Point> corners;
  for (const auto& polygon : polygons) {
    corners.clear();
    for (const std::size_t index : polygon) {
      require(index < surface.points.size(),
              "a polygon refers to a point that is not there; repair the file");
      corners.push_back(surface.points[index]);
    }
    const auto triangles = internal::triangulated_polygon(corners);
    if (triangles.empty())
      throw Deformable_simplicial_complexes::File_error(
          path + ": polygon " + std::to_string(&polygon - polygons.data()) +
              " cannot be triangulated; replace it by triangles",
          path);
    for (const auto& triangle : triangles)
      surface.triangles.push_back(
          {polygon[triangle[0]], polygon[triangle[1]], polygon[triangle[2]]});
  }
  return surface;
}

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

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
  Deformable_simplicial_complexes::internal::write_surface(path, extract_interface(dsc));
}

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

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
  Deformable_simplicial_complexes::internal::write_surface(path, extract_interface(dsc, a, b));
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_LABELLED_SURFACE_3_H
