// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_MEDIT_3_H
#define CGAL_MESH_FILES_MEDIT_3_H

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Interface_remeshing/extract_interface_3.h>
#include <CGAL/Mesh_files/Mesh_entities.h>
#include <CGAL/Mesh_files/Unused_content.h>
#include <CGAL/Mesh_files/internal/grids/Medit_reader.h>
#include <CGAL/Mesh_files/internal/grids/Written_vertices.h>
#include <CGAL/Mesh_files/internal/text/files.h>
#include <CGAL/Mesh_files/replace_file.h>
#include <CGAL/Mesh_support/Progress_scope.h>

namespace CGAL::IO {

/*!
\ingroup PkgMeshFilesRef

Writes a complex in the MEDIT text format (`.mesh`). n log n in the number of cells; the text is
buffered in memory.

The reference of a tetrahedron is its label. The triangles are those of `entities`, followed by the
other triangles of the interface, with normals out of the larger label. The reference of the latter
is a number for each pair of labels that meet; the numbers begin at 1 or above the references of
`entities`. Comments at the head of the file list the pairs. Coordinates are user coordinates with
17 significant digits, from which they can be read back exactly.

\param out the stream; errors are reported by its state. Its format flags have no effect.
\param dsc the complex
\param entities edges, triangles and references that are written, too; indices of points refer to
       `dsc.vertices()`, without copies of vertices where a `Solid_domain` touches itself

\pre `entities.vertex_references` is empty or has one element for each vertex. All indices in
     `entities` refer to vertices, edges and triangles that exist. The largest reference is so small
     that the references of the additional pairs of labels are values of type `int`.
*/
template <class Traits, class Tds, class QualityMeasure, class Domain>
void write_MEDIT(std::ostream& out,
                 const Deformable_simplicial_complex_3<Traits, Tds, QualityMeasure, Domain>& dsc,
                 const Deformable_simplicial_complexes::Mesh_entities& entities =
                     Deformable_simplicial_complexes::Mesh_entities()) {
  namespace internal = Deformable_simplicial_complexes::internal;
  const internal::Written_vertices number(dsc);
  const auto cells = dsc.cells();
  const auto surface = Deformable_simplicial_complexes::extract_interface(dsc);
  std::vector<std::array<std::size_t, 3>> interface_;
  for (const auto& t : surface.triangles)
    interface_.push_back({number(surface.vertices[t[0]]), number(surface.vertices[t[1]]),
                          number(surface.vertices[t[2]])});
  const internal::Medit_triangles triangles(entities.triangles, interface_, surface.labels);

  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<double>::max_digits10);
  text << "MeshVersionFormatted 2\n";
  for (std::size_t i = 0; i < triangles.pairs().size(); ++i)
    text << "# Triangles with reference " << triangles.reference(i) << " have normals from label "
         << triangles.pairs()[i][0] << " to label " << triangles.pairs()[i][1] << '\n';
  text << "Dimension 3\n";

  text << "Vertices\n" << number.vertices().size() << '\n';
  for (std::size_t i = 0; i < number.vertices().size(); ++i) {
    Deformable_simplicial_complexes::Progress_scope::check();
    const auto p = dsc.user_position(number.vertices()[i]);
    text << p.x() << ' ' << p.y() << ' ' << p.z() << ' '
         << (entities.vertex_references.empty() ? 0 : entities.vertex_references[i]) << '\n';
  }
  text << "Tetrahedra\n" << cells.size() << '\n';
  for (const auto c : cells) {
    Deformable_simplicial_complexes::Progress_scope::check();
    for (int i = 0; i < 4; ++i)
      text << number(c->vertex(i)) + 1 << ' ';
    text << dsc.label(c) << '\n';
  }
  text << "Triangles\n" << triangles.triangles().size() << '\n';
  internal::write_medit_simplices(text, triangles.triangles());
  internal::write_medit_section(text, "Edges", entities.edges);
  internal::write_medit_section(text, "Corners", entities.corners);
  internal::write_medit_section(text, "RequiredVertices", entities.required_vertices);
  internal::write_medit_section(text, "Ridges", entities.ridges);
  internal::write_medit_section(text, "RequiredEdges", entities.required_edges);
  internal::write_medit_section(text, "RequiredTriangles", entities.required_triangles);
  text << "End\n";
  out << text.str();
}

/*!
\ingroup PkgMeshFilesRef

Writes a complex to a file in the MEDIT text format. A temporary file in the same folder is written
and renamed when complete.

\param path name of the file; its folder must exist
\param dsc, entities as above

\throws Deformable_simplicial_complexes::File_error if the file cannot be written; an older file of
        that name is then unchanged
*/
template <class Traits, class Tds, class QualityMeasure, class Domain>
void write_MEDIT(const std::string& path,
                 const Deformable_simplicial_complex_3<Traits, Tds, QualityMeasure, Domain>& dsc,
                 const Deformable_simplicial_complexes::Mesh_entities& entities =
                     Deformable_simplicial_complexes::Mesh_entities()) {
  Deformable_simplicial_complexes::replace_file(
      path, [&](std::ostream& out) { write_MEDIT(out, dsc, entities); });
}

/*!
\ingroup PkgMeshFilesRef

Reads labeled tetrahedra in the MEDIT text format. The result is valid input of
`make_deformable_simplicial_complex_3()` and `Labeled_complex::assign()`. Linear in the size of the
text. Memory is allocated only for simplices that the text contains.

The sections `Vertices` and `Tetrahedra` and the sections stored in `Mesh_entities` are read. Other
sections and comments are skipped. The references of tetrahedra become labels. The geometry of the
tetrahedra is not checked.

\tparam Point a point type that can be constructed from three coordinates

\param in the stream
\param points, tetrahedra, labels replaced by the input; indices start from 0. Equal corners are
       merged; the first one counts.
\param path name of the input in messages
\param entities replaced by the edges, triangles and references of the input, unless it is null
\param unused the skipped sections are added to it, unless it is null; also the references of
       vertices, if they differ at equal points

\throws Deformable_simplicial_complexes::File_error with the number of the line if the text is not a
        mesh of dimension 3, contains no tetrahedra, or contains other three-dimensional cells, such
        as hexahedra or curved tetrahedra. Also if a number is missing or wrong, a coordinate is not
        finite, a reference is not an integer of 32 bits, or an index is out of range. The arguments
        are then unchanged.
*/
template <class Point>
void read_MEDIT(std::istream& in, std::vector<Point>& points,
                std::vector<std::array<std::size_t, 4>>& tetrahedra, std::vector<int>& labels,
                const std::string& path = "MEDIT text",
                Deformable_simplicial_complexes::Mesh_entities* entities = nullptr,
                Deformable_simplicial_complexes::Unused_content* unused = nullptr) {
  Deformable_simplicial_complexes::internal::Medit_reader reader(in, path);
  reader.read();
  std::vector<Point> new_points;
  new_points.reserve(reader.points().size());
  for (const auto& [x, y, z] : reader.points())
    new_points.emplace_back(x, y, z);
  points.swap(new_points);
  tetrahedra.swap(reader.tetrahedra());
  labels.swap(reader.labels());
  if (entities != nullptr)
    *entities = std::move(reader.entities());
  if (unused != nullptr)
    unused->add(reader.unused());
}

/*!
\ingroup PkgMeshFilesRef

Reads labeled tetrahedra from a file in the MEDIT text format.

\param path name of the file
\param points, tetrahedra, labels, entities, unused as above

\throws Deformable_simplicial_complexes::File_error if the file cannot be opened, and as above
*/
template <class Point>
void read_MEDIT(const std::string& path, std::vector<Point>& points,
                std::vector<std::array<std::size_t, 4>>& tetrahedra, std::vector<int>& labels,
                Deformable_simplicial_complexes::Mesh_entities* entities = nullptr,
                Deformable_simplicial_complexes::Unused_content* unused = nullptr) {
  Deformable_simplicial_complexes::internal::Input_file in(path, ".mesh");
  read_MEDIT(in, points, tetrahedra, labels, path, entities, unused);
}

} // namespace CGAL::IO

#endif // CGAL_MESH_FILES_MEDIT_3_H
