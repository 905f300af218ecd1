// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IO_MEDIT_3_H
#define CGAL_IO_MEDIT_3_H

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/internal/text/File_scanner.h>
#include <CGAL/Deformable_simplicial_complexes/internal/text/files.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Vertex_numbering.h>
#include <CGAL/extract_interface_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <istream>
#include <limits>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace IO {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

writes a complex in the MEDIT text format (`.mesh`).

The reference of a tetrahedron is its label. The triangles are those of the interface, with normals
out of the larger label; their reference is a number from 1 for each pair of labels that meet, and
comments at the head of the file tell the pairs. Vertices have the reference 0. Coordinates are user
coordinates with 17 significant digits, from which they can be read back exactly.

\param out is the stream; failures are left in its state. Its format flags do not matter.
\param dsc is the complex.

n log n in the number of cells; takes memory for the text.
*/
template <class Traits, class Tds, class QualityMeasure>
void write_MEDIT(std::ostream& out,
                 const Deformable_simplicial_complex_3<Traits, Tds, QualityMeasure>& dsc) {
  namespace internal = Deformable_simplicial_complexes::internal;
  const internal::Vertex_numbering number(dsc.vertices());
  const auto cells = dsc.cells();
  const auto surface = extract_interface(dsc);
  auto pairs = surface.labels;
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());

  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<double>::max_digits10);
  text << "MeshVersionFormatted 2\n";
  for (std::size_t i = 0; i < pairs.size(); ++i)
    text << "# Triangles with reference " << i + 1 << " have normals from label " << pairs[i][0]
         << " to label " << pairs[i][1] << '\n';
  text << "Dimension 3\n";

  text << "Vertices\n" << number.vertices().size() << '\n';
  for (const auto v : number.vertices()) {
    const auto p = dsc.user_position(v);
    text << p.x() << ' ' << p.y() << ' ' << p.z() << " 0\n";
  }
  text << "Tetrahedra\n" << cells.size() << '\n';
  for (const auto c : cells) {
    for (int i = 0; i < 4; ++i)
      text << number(c->vertex(i)) + 1 << ' ';
    text << dsc.label(c) << '\n';
  }
  text << "Triangles\n" << surface.triangles.size() << '\n';
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    for (const std::size_t corner : surface.triangles[i])
      text << number(surface.vertices[corner]) + 1 << ' ';
    const auto pair = std::lower_bound(pairs.begin(), pairs.end(), surface.labels[i]);
    text << pair - pairs.begin() + 1 << '\n';
  }
  text << "End\n";
  out << text.str();
}

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

writes a complex to a file in the MEDIT text format. The file is written beside its final place and
renamed when complete.

\param path is the name of the file; its folder must exist.
\param dsc is the complex.

\throws Deformable_simplicial_complexes::File_error if the file cannot be written; an older file
of that name is unchanged then.
*/
template <class Traits, class Tds, class QualityMeasure>
void write_MEDIT(const std::string& path,
                 const Deformable_simplicial_complex_3<Traits, Tds, QualityMeasure>& dsc) {
  Deformable_simplicial_complexes::internal::replace_file_by_stream(
      path, [&](std::ostream& out) { write_MEDIT(out, dsc); });
}

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

reads labelled tetrahedra in the MEDIT text format, as
`make_deformable_simplicial_complex_3()` and `Deformable_simplicial_complex_3::assign()` take them.

The sections `Vertices` and `Tetrahedra` are read, all others are skipped, and so are comments. The
references of tetrahedra become labels. What the tetrahedra look like is not checked.

\tparam Point is a point type that can be constructed from three coordinates.

\param in is the stream.
\param points, tetrahedra, labels are replaced by what was read; indices start from 0.
\param path is named in messages.

\throws Deformable_simplicial_complexes::File_error with the number of the line if the text is not
a mesh of dimension 3, a number is missing or wrong, a coordinate is not finite, an index refers to
no vertex, or there are no tetrahedra. The arrays are unchanged then.

Linear in the size of the text. Memory is never taken for more simplices than there are.
*/
template <class Point>
void read_MEDIT(std::istream& in, std::vector<Point>& points,
                std::vector<std::array<std::size_t, 4>>& tetrahedra, std::vector<int>& labels,
                const std::string& path = "MEDIT text") {
  Deformable_simplicial_complexes::internal::File_scanner scanner(in, path);
  std::vector<Point> new_points;
  std::vector<std::array<std::size_t, 4>> new_tetrahedra;
  std::vector<int> new_labels;
  std::size_t largest_index = 0, line_of_largest_index = 0;

  const auto read_coordinate = [&] {
    const double x = scanner.number<double>();
    if (!std::isfinite(x))
      scanner.fail("a coordinate is not a finite number; correct it");
    return x;
  };
  const auto read_vertex = [&] {
    const double x = read_coordinate(), y = read_coordinate(), z = read_coordinate();
    new_points.emplace_back(x, y, z);
    scanner.number<int>();
  };
  // The vertices may come later in the file.
  const auto read_index = [&] {
    const std::size_t index = scanner.number<std::size_t>();
    if (index == 0)
      scanner.fail("indices of vertices start from 1; correct the 0");
    if (index > largest_index) {
      largest_index = index;
      line_of_largest_index = scanner.line_number();
    }
    return index - 1;
  };
  const auto read_tetrahedron = [&] {
    std::array<std::size_t, 4> tetrahedron;
    for (std::size_t& index : tetrahedron)
      index = read_index();
    new_tetrahedra.push_back(tetrahedron);
    new_labels.push_back(scanner.number<int>());
  };
  const auto read_section = [&](const auto& read_element) {
    for (std::size_t n = scanner.number<std::size_t>(); n > 0; --n)
      read_element();
    return scanner.next();
  };

  if (!scanner.next() || scanner.word() != "MeshVersionFormatted")
    scanner.fail("the file does not begin with MeshVersionFormatted; is it a MEDIT text file?");
  scanner.number<int>();
  for (bool is_in_file = scanner.next(); is_in_file && scanner.word() != "End";) {
    if (!scanner.is_keyword())
      scanner.fail(Deformable_simplicial_complexes::internal::in_quotes(scanner.word()) +
                   " is not expected; is the number of elements above it right?");
    if (scanner.word() == "Dimension") {
      if (scanner.number<int>() != 3)
        scanner.fail("the dimension must be 3; choose a mesh of tetrahedra");
      is_in_file = scanner.next();
    } else if (scanner.word() == "Vertices")
      is_in_file = read_section(read_vertex);
    else if (scanner.word() == "Tetrahedra")
      is_in_file = read_section(read_tetrahedron);
    else
      while ((is_in_file = scanner.next()) && !scanner.is_keyword())
        continue;
  }
  if (new_tetrahedra.empty())
    scanner.fail("there are no tetrahedra; choose a mesh that has some");
  if (largest_index > new_points.size())
    scanner.fail("there is no vertex " + std::to_string(largest_index) + "; correct the index",
                 line_of_largest_index);
  points.swap(new_points);
  tetrahedra.swap(new_tetrahedra);
  labels.swap(new_labels);
}

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

reads labelled tetrahedra from a file in the MEDIT text format.

\param path is the name of the file.
\param points, tetrahedra, labels are replaced by what was read; indices start from 0.

\throws Deformable_simplicial_complexes::File_error if the file cannot be opened, and as for
streams.
*/
template <class Point>
void read_MEDIT(const std::string& path, std::vector<Point>& points,
                std::vector<std::array<std::size_t, 4>>& tetrahedra, std::vector<int>& labels) {
  std::ifstream in(path, std::ios::binary);
  if (!in)
    throw Deformable_simplicial_complexes::File_error(
        "cannot open " + path + ": check that it exists and may be read", path);
  read_MEDIT(in, points, tetrahedra, labels, path);
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_MEDIT_3_H
