// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_LABELED_CURVES_2_H
#define CGAL_MESH_FILES_LABELED_CURVES_2_H

#include <CGAL/Complex_construction/Labeled_curve_2.h>
#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Interface_remeshing/extract_interface_2.h>
#include <CGAL/Mesh_files/Unused_content.h>
#include <CGAL/Mesh_files/internal/curves/read_poly.h>
#include <CGAL/Mesh_files/internal/curves/read_wkt.h>
#include <CGAL/Mesh_files/replace_file.h>

namespace CGAL::IO {

/*!
\ingroup PkgMeshFilesRef

Reads closed curves from a file of well-known text (`.wkt`), for
`make_deformable_simplicial_complex_2()`. Each `POLYGON`, `MULTIPOLYGON`, closed `LINESTRING` and
`MULTILINESTRING` is a curve, also in a `GEOMETRYCOLLECTION`. The labels are 1, 2 and so on. Linear
in the size of the file.

\param path name of the file
\param unused the unused content of the file is added to it, unless it is null: points, empty
       geometries, spatial reference systems
\throws Deformable_simplicial_complexes::File_error if the file cannot be read, or its content is
        not as described above
*/
template <class Point = Exact_predicates_inexact_constructions_kernel::Point_2>
std::vector<Deformable_simplicial_complexes::Labeled_curve_2<Point>>
read_labeled_curves(const std::string& path,
                    Deformable_simplicial_complexes::Unused_content* unused = nullptr) {
  Deformable_simplicial_complexes::internal::Wkt_reader<Point> reader(path);
  auto curves = reader.read();
  if (unused)
    unused->add(reader.unused());
  return curves;
}

/*!
\ingroup PkgMeshFilesRef

Reads segments from a file in the format of Triangle (`.poly`), for
`make_deformable_simplicial_complex_2()`. The attribute of a region, which must be an integer, is
its label. Holes have label 0. If the file has no regions, everything enclosed by segments except
holes has label 1. Linear in the size of the file.

\param path name of the file. If it has no points, they are read from the file of the same name with
       the extension `.node`.
\param unused the unused content of the file is added to it, unless it is null: attributes and
       boundary markers of points and segments, points that are not ends of segments, and area
       constraints
\throws Deformable_simplicial_complexes::File_error if the file cannot be read, or its content is
        not as described above
*/
template <class Point = Exact_predicates_inexact_constructions_kernel::Point_2>
Deformable_simplicial_complexes::Seeded_segments_2<Point>
read_seeded_segments(const std::string& path,
                     Deformable_simplicial_complexes::Unused_content* unused = nullptr) {
  Deformable_simplicial_complexes::internal::Poly_reader<Point> reader(path);
  auto segments = reader.read();
  if (unused)
    unused->add(reader.unused());
  return segments;
}

/*!
\ingroup PkgMeshFilesRef

Writes the regions of a complex in 2D as well-known text: a `MULTIPOLYGON` for each label except 0,
by increasing label, in user coordinates. Coordinates are written with all significant digits.
Labels are not written; regions that are read again have the labels 1, 2 and so on. n log n in the
number of triangles.

\param path name of the file; its folder must exist
\param dsc the complex; its domain is not a torus
\throws Deformable_simplicial_complexes::File_error if the file cannot be written; an older file of
        that name is then unchanged
*/
template <class Traits, class Tds>
void write_WKT(const std::string& path, const Deformable_simplicial_complex_2<Traits, Tds>& dsc) {
  Deformable_simplicial_complexes::replace_file(path, [&](std::ostream& out) {
    out.precision(std::numeric_limits<double>::max_digits10);
    const auto write_ring = [&](const auto& ring) {
      out << '(';
      for (const auto& p : ring)
        out << p.x() << ' ' << p.y() << ", ";
      out << ring[0].x() << ' ' << ring[0].y() << ')';
    };
    for (const auto& [label, polygons] : Deformable_simplicial_complexes::extract_polygons(dsc)) {
      if (label == 0)
        continue;
      const char* separator = "";
      out << "MULTIPOLYGON (";
      for (const auto& polygon : polygons) {
        out << separator << '(';
        write_ring(polygon.outer_boundary());
        for (const auto& hole : polygon.holes()) {
          out << ", ";
          write_ring(hole);
        }
        out << ')';
        separator = ", ";
      }
      out << ")\n";
    }
  });
}

/*!
\ingroup PkgMeshFilesRef

Writes the interface of a complex in 2D in the format of Triangle (`.poly`), in user coordinates.
The file also contains the boundary of the domain at labels other than 0, and a region for each
connected component of these labels. Coordinates are written with all significant digits. n log n in
the number of triangles.

\param path name of the file; its folder must exist
\param dsc the complex; its domain is not a torus
\throws Deformable_simplicial_complexes::File_error if the file cannot be written; an older file of
        that name is then unchanged
*/
template <class Traits, class Tds>
void write_poly(const std::string& path, const Deformable_simplicial_complex_2<Traits, Tds>& dsc) {
  namespace internal = Deformable_simplicial_complexes::internal;
  using Complex = Deformable_simplicial_complex_2<Traits, Tds>;
  using Cell_handle = typename Complex::Cell_handle;
  std::vector<typename Complex::Facet> walls = dsc.interface_facets();
  for (const Cell_handle c : dsc.cells())
    for (int i = 0; i < 3; ++i)
      if (dsc.label(c) != 0 && dsc.is_infinite(c->neighbor(i)))
        walls.emplace_back(c, i);
  const internal::Extracted_facets<Complex> extracted(dsc, walls, false);
  std::vector<Cell_handle> largest; // largest triangle of each component
  std::set<Cell_handle> found;
  for (const Cell_handle first : dsc.cells()) {
    if (dsc.label(first) == 0 || found.count(first) > 0)
      continue;
    largest.push_back(first);
    for (const Cell_handle c : internal::connected_cells(dsc, first, found))
      if (dsc.measure(c) > dsc.measure(largest.back()))
        largest.back() = c;
  }
  Deformable_simplicial_complexes::replace_file(path, [&](std::ostream& out) {
    out.precision(std::numeric_limits<double>::max_digits10);
    out << extracted.points.size() << " 2 0 0\n";
    for (std::size_t i = 0; i < extracted.points.size(); ++i)
      out << i << ' ' << extracted.points[i].x() << ' ' << extracted.points[i].y() << '\n';
    out << extracted.facets.size() << " 0\n";
    for (std::size_t i = 0; i < extracted.facets.size(); ++i)
      out << i << ' ' << extracted.facets[i][0] << ' ' << extracted.facets[i][1] << '\n';
    out << "0\n" << largest.size() << '\n';
    for (std::size_t i = 0; i < largest.size(); ++i) {
      const auto middle = centroid(dsc.user_position(largest[i]->vertex(0)),
                                   dsc.user_position(largest[i]->vertex(1)),
                                   dsc.user_position(largest[i]->vertex(2)));
      out << i << ' ' << middle.x() << ' ' << middle.y() << ' ' << dsc.label(largest[i]) << " 0\n";
    }
  });
}

} // namespace CGAL::IO

#endif // CGAL_MESH_FILES_LABELED_CURVES_2_H
