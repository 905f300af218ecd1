// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_LABELED_SURFACE_3_H
#define CGAL_MESH_FILES_LABELED_SURFACE_3_H

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Interface_remeshing/extract_interface_3.h>
#include <CGAL/Mesh_files/File_error.h>
#include <CGAL/Mesh_files/Label_names.h>
#include <CGAL/Mesh_files/Mesh_arrays.h>
#include <CGAL/Mesh_files/Surface_parts.h>
#include <CGAL/Mesh_files/Unused_content.h>
#include <CGAL/Mesh_files/internal/surfaces/read_polygons.h>
#include <CGAL/Mesh_files/internal/surfaces/surface_sinks.h>
#include <CGAL/Mesh_files/internal/text/File_scanner.h>
#include <CGAL/Mesh_files/internal/text/files.h>
#include <CGAL/Mesh_files/replace_file.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/internal/sets/equal_points.h>
#include <CGAL/Triangle_soup_repair/Labeled_surface_3.h>

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Kernel/global_functions.h>

namespace CGAL {
namespace Deformable_simplicial_complexes::internal {

using Triangles_of_labels = std::map<int, std::vector<std::array<std::size_t, 3>>>;

// Returns the triangles that bound each label other than 0, with normals out of the label.
// Triangles between two labels are triangles of both.
template <class Surface> Triangles_of_labels triangles_of_labels(const Surface& surface) {
  Triangles_of_labels result;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    auto triangle = surface.triangles[t];
    for (const int label : surface.labels[t]) {
      if (label != 0)
        result[label].push_back(triangle);
      std::swap(triangle[1], triangle[2]);
    }
  }
  return result;
}

// Returns the name of a part in one line, which the next line does not continue. A label without a
// name gets one that no other label has.
inline std::string part_name(int label, const Label_names& names) {
  const auto name = names.find(label);
  std::string result = name == names.end() ? "label " + std::to_string(label) : name->second;
  while (name == names.end() && std::any_of(names.begin(), names.end(), [&](const auto& other) {
           return other.second == result;
         }))
    result += '\'';
  std::replace_if(
      result.begin(), result.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  if (!result.empty() && result.back() == '\\')
    result.back() = '/';
  return result;
}

// Writes a solid for each label as STL text.
template <class Surface>
void write_solids(std::ostream& out, const Surface& surface, const Label_names& names) {
  for (const auto& [label, triangles] : triangles_of_labels(surface)) {
    out << "solid " << part_name(label, names) << '\n';
    for (const auto& [a, b, c] : triangles) {
      const auto &p = surface.points[a], &q = surface.points[b], &r = surface.points[c];
      using Vector = decltype(q - p);
      const Vector normal = collinear(p, q, r) ? Vector(1, 0, 0) : unit_normal(p, q, r);
      out << "facet normal " << normal << "\nouter loop\nvertex " << p << "\nvertex " << q
          << "\nvertex " << r << "\nendloop\nendfacet\n";
    }
    out << "endsolid " << part_name(label, names) << '\n';
  }
}

// Writes an object for each label as OBJ.
template <class Surface>
void write_objects(std::ostream& out, const Surface& surface, const Label_names& names) {
  for (const auto& p : surface.points)
    out << "v " << p << '\n';
  for (const auto& [label, triangles] : triangles_of_labels(surface)) {
    out << "o " << part_name(label, names) << '\n';
    for (const auto& [a, b, c] : triangles)
      out << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
  }
}

// Returns the format by the extension of the file.
inline Surface_format surface_format(const std::string& path) {
  const std::string extension = lower_case_extension(path);
  return extension == ".off"   ? Surface_format::off
         : extension == ".obj" ? Surface_format::obj
         : extension == ".ply" ? Surface_format::ply
         : extension == ".stl" ? Surface_format::stl
                               : Surface_format::none;
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

// Writes a surface with a property of its vertices for each array, as PLY text.
template <class Surface>
void write_ply_with_properties(std::ostream& out, const Surface& surface,
                               const std::vector<Mesh_array>& arrays) {
  out << "ply\nformat ascii 1.0\nelement vertex " << surface.points.size()
      << "\nproperty double x\nproperty double y\nproperty double z\n";
  for (const Mesh_array& array : arrays)
    out << "property float " << array.name << '\n';
  out << "element face " << surface.triangles.size()
      << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    const auto& p = surface.points[i];
    out << p.x() << ' ' << p.y() << ' ' << p.z();
    for (const Mesh_array& array : arrays)
      out << ' ' << static_cast<float>(array.values[i]);
    out << '\n';
  }
  for (const auto& [a, b, c] : surface.triangles)
    out << "3 " << a << ' ' << b << ' ' << c << '\n';
}

} // namespace Deformable_simplicial_complexes::internal

namespace IO {

/*!
\ingroup PkgMeshFilesRef

Reads a surface from a file in one of the formats OFF, OBJ, PLY and STL, chosen by the extension.
Linear in the size of the file; n log n for STL. Memory is allocated only for points and triangles
that the file contains, for any number that it announces.

Polygons with more than three vertices are triangulated one by one. Polygons with more than four
vertices are projected along their normals, and their constrained Delaunay triangulations are used.
In STL files, triangles share no points; points with the same coordinates are merged. The geometry
of the surface is not checked here, but by `make_deformable_simplicial_complex_3()`.

The names of solids in STL files, and of objects or groups in OBJ files, divide the surface into
parts. `separate_parts()` returns their surfaces.

All other content of the file is added to `unused`: colors, normals, texture coordinates, materials,
groups of several objects, lines, other elements, points without polygons, and polygons with fewer
than three corners. Facet normals of STL files are redundant and not added.

\tparam Point a point type of a \cgal kernel

\param path name of the file
\param label label of the solid that the surface bounds
\param unused the unused content of the file is added to it, unless it is null. After an exception,
       a part of the unused content may have been added.
\param parts replaced by the parts of the surface, unless it is null; then the names are unused

\throws Deformable_simplicial_complexes::File_error if the file cannot be opened or understood, has
        no polygons or more elements than it announces, or describes a part of the surface without
        polygons. Also if a coordinate is not finite, a polygon refers to a point that does not
        exist, or a polygon intersects itself and cannot be triangulated.
*/
template <class Point = Exact_predicates_inexact_constructions_kernel::Point_3>
Deformable_simplicial_complexes::Labeled_surface_3<Point>
read_labeled_surface(const std::string& path, int label = 1,
                     Deformable_simplicial_complexes::Unused_content* unused = nullptr,
                     Deformable_simplicial_complexes::Surface_parts* parts = nullptr) {
  namespace internal = Deformable_simplicial_complexes::internal;
  const auto require = [&](bool condition, const char* message) {
    if (!condition)
      throw Deformable_simplicial_complexes::File_error(path + ": " + message, path);
  };
  const internal::Surface_format format = internal::surface_format(path);
  require(format != internal::Surface_format::none,
          "the extension is not a surface format; choose a .off, .obj, .ply or .stl file");
  const Deformable_simplicial_complexes::Progress_phase phase("reading a surface");
  internal::Input_file in(path, internal::lower_case_extension(path));
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  require(!error, "cannot read the file; check its permissions");

  // Polygons may precede their points in a file. The file is therefore read twice: first the
  // points, then the polygons.
  constexpr std::size_t least_bytes_of_point = 3;
  internal::File_scanner first_scanner(in, path), second_scanner(in, path);
  internal::Point_sink<Point> points{
      first_scanner, static_cast<std::size_t>(size) / least_bytes_of_point, unused, {}};
  internal::read_polygons(in, format, first_scanner, points);
  points.unused("normals of points", points.number_of_normals);
  internal::report_unused_names(points, parts != nullptr, format);
  require(points.number_of_polygons != 0, "there are no polygons; choose a file with polygons");
  Deformable_simplicial_complexes::Labeled_surface_3<Point> surface;
  surface.label = label;
  surface.points.swap(points.points);
  surface.triangles.reserve(points.number_of_triangles);
  in.clear();
  in.seekg(0);
  internal::Triangle_sink<Point> triangles{second_scanner, surface, points.parts.dividing(), {}};
  internal::read_polygons(in, format, second_scanner, triangles);
  if (parts)
    *parts = {triangles.parts.names(), std::move(triangles.part_of_triangle)};
  if (format == internal::Surface_format::stl) {
    internal::merge_equal_points<3>(surface.points, surface.triangles);
    surface.points.shrink_to_fit();
  } else if (unused)
    unused->add("points without polygons", internal::number_of_unused_points(surface));
  return surface;
}

/*!
\ingroup PkgMeshFilesRef

Writes an extracted and possibly subdivided interface to a file in one of the formats OFF, OBJ, PLY
and STL, chosen by the extension.

All formats are written as text, in user coordinates with 17 significant digits. Triangles keep
their order and their orientation. A temporary file in the same folder is written and renamed when
complete.

\param path name of the file; its folder must exist
\param surface a result of `extract_interface()` or `subdivide_interface()`

\throws Deformable_simplicial_complexes::File_error if the extension is not one of these or the file
        cannot be written; an older file of that name is then unchanged
*/
template <class Complex>
void write_interface(const std::string& path,
                     const Deformable_simplicial_complexes::Interface_surface_3<Complex>& surface) {
  namespace internal = Deformable_simplicial_complexes::internal;
  const internal::Surface_format format = internal::surface_format(path);
  if (format == internal::Surface_format::none)
    throw Deformable_simplicial_complexes::File_error(
        path + " does not have the extension of a surface format: choose .off, .obj, .ply or .stl",
        path);
  Deformable_simplicial_complexes::replace_file(path, [&](std::ostream& out) {
    out.precision(std::numeric_limits<double>::max_digits10);
    if (!internal::write_soup(out, format, surface.points, surface.triangles))
      out.setstate(std::ios::failbit);
  });
}

/*!
\ingroup PkgMeshFilesRef

Writes an extracted and possibly subdivided interface with names of labels. If there are names, STL
files get a solid, and OBJ files an object, for each label other than 0: the whole boundary of the
label, with normals out of it. Triangles between two such labels belong to both. Labels without name
are called like `label 3`. Otherwise the function is the same as `write_interface()`.

\param path name of the file; its folder must exist
\param surface a result of `extract_interface()` or `subdivide_interface()`
\param names names of labels; line breaks are replaced by spaces. The other formats contain no names.

\throws Deformable_simplicial_complexes::File_error as above

\sa `read_labeled_surface()`
*/
template <class Complex>
void write_named_interface(
    const std::string& path,
    const Deformable_simplicial_complexes::Interface_surface_3<Complex>& surface,
    const Deformable_simplicial_complexes::Label_names& names) {
  namespace internal = Deformable_simplicial_complexes::internal;
  const internal::Surface_format format = internal::surface_format(path);
  const bool has_solids = format == internal::Surface_format::stl;
  if (names.empty() || (!has_solids && format != internal::Surface_format::obj))
    return write_interface(path, surface);
  Deformable_simplicial_complexes::replace_file(path, [&](std::ostream& out) {
    out.precision(std::numeric_limits<double>::max_digits10);
    has_solids ? internal::write_solids(out, surface, names)
               : internal::write_objects(out, surface, names);
  });
}

/*!
\ingroup PkgMeshFilesRef

Writes an extracted and possibly subdivided interface to a PLY file, with values at its points, such
as the velocities for motion blur. Each array is a property of type `float` of the vertices.
Otherwise the function is the same as the overload above.

\param path name of the file, with the extension `.ply`; its folder must exist
\param surface a result of `extract_interface()` or `subdivide_interface()`
\param arrays arrays with one number for each point of the surface. Their types are ignored.

\throws Deformable_simplicial_complexes::File_error if the extension is not `.ply`, or the file
        cannot be written; an older file of that name is then unchanged

\pre Each array has one component and as many rows as the surface has points. Names consist of
     letters, digits and underscores, are not x, y or z, and differ from each other.
*/
template <class Complex>
void write_interface(const std::string& path,
                     const Deformable_simplicial_complexes::Interface_surface_3<Complex>& surface,
                     const std::vector<Deformable_simplicial_complexes::Mesh_array>& arrays) {
  namespace internal = Deformable_simplicial_complexes::internal;
  if (internal::surface_format(path) != internal::Surface_format::ply)
    throw Deformable_simplicial_complexes::File_error(
        path + " cannot contain values at points: choose the extension .ply", path);
  Deformable_simplicial_complexes::replace_file(path, [&](std::ostream& out) {
    out.precision(std::numeric_limits<double>::max_digits10);
    internal::write_ply_with_properties(out, surface, arrays);
  });
}

/*!
\ingroup PkgMeshFilesRef

Writes the whole interface to a file in one of the formats OFF, OBJ, PLY and STL, chosen by the
extension.

All formats are written as text, in user coordinates with 17 significant digits. Normals point out
of the larger label. A temporary file in the same folder is written and renamed when complete.

\param path name of the file; its folder must exist
\param dsc the complex

\throws Deformable_simplicial_complexes::File_error if the extension is not one of these or the file
        cannot be written; an older file of that name is then unchanged

\sa `extract_interface()`
*/
template <class Traits, class Tds, class QualityMeasure>
void write_interface(const std::string& path,
                     const Deformable_simplicial_complex_3<Traits, Tds, QualityMeasure>& dsc) {
  write_interface(path, Deformable_simplicial_complexes::extract_interface(dsc));
}

/*!
\ingroup PkgMeshFilesRef

Writes the interface between two labels, with normals out of `a` into `b`. Otherwise the function is
the same as the overload for the whole interface.

\param path name of the file; its folder must exist
\param dsc the complex
\param a, b different labels

\throws Deformable_simplicial_complexes::File_error as above
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

#endif // CGAL_MESH_FILES_LABELED_SURFACE_3_H
