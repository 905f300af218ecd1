// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DISTRIBUTED_COMPLEXES_PVTU_H
#define CGAL_DISTRIBUTED_COMPLEXES_PVTU_H

#include <CGAL/Distributed_complexes/Distributed_complex.h>
#include <CGAL/Mesh_files/internal/grids/Vtu_document.h>
#include <CGAL/Mesh_files/internal/grids/write_vtu.h>
#include <CGAL/Mesh_files/internal/text/Xml_element.h>
#include <CGAL/Mesh_files/replace_file.h>

namespace CGAL {
namespace Deformable_simplicial_complexes::internal {

// Returns the name of the file of a rank: `path` without its extension, and the number of the rank.
inline std::string piece_path(const std::string& path, int rank) {
  return std::filesystem::path(path).replace_extension().string() + "_" + std::to_string(rank) +
         ".vtu";
}

// Writes the document of each rank, and the file that lists them. `cell_arrays` are the elements of
// the cell arrays in the list. An error on one rank is thrown on all ranks.
inline void write_pieces(const std::string& path, Communicator& communicator,
                         const Vtu_document& document, const std::string& cell_arrays) {
  communicator.call_together([&] {
    replace_file(piece_path(path, communicator.rank()),
                 [&](std::ostream& out) { document.write(out); });
  });
  // All pieces are complete.
  communicator.call_together([&] {
    if (communicator.rank() != 0)
      return;
    replace_file(path, [&](std::ostream& out) {
      out << "<?xml version=\"1.0\"?>\n"
             "<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
             "header_type=\"UInt64\">\n"
             "  <PUnstructuredGrid GhostLevel=\"0\">\n"
             "    <PCellData>\n"
          << cell_arrays
          << "    </PCellData>\n"
             "    <PPoints>\n"
             "      <PDataArray type=\"Float64\" Name=\"points\" NumberOfComponents=\"3\"/>\n"
             "    </PPoints>\n";
      for (int r = 0; r < communicator.size(); ++r)
        out << "    <Piece Source=\""
            << xml_escaped(std::filesystem::path(piece_path(path, r)).filename().string())
            << "\"/>\n";
      out << "  </PUnstructuredGrid>\n"
             "</VTKFile>\n";
    });
  });
}

} // namespace Deformable_simplicial_complexes::internal

namespace IO {

/*!
\ingroup PkgDistributedComplexesRef

Writes all cells of a distributed complex for ParaView. For `a.pvtu`, the rank 3 writes its own
cells to `a_3.vtu`. The first rank writes `path`, which lists the files. Points have user
coordinates. Linear in the number of own cells. The cell data are `label`, `quality`, and `rank`,
the owner. Collective.

\param path name of the list, with the extension `.pvtu`; its folder must exist on all ranks
\param complex the complex
\throws Deformable_simplicial_complexes::Error on all ranks if a file cannot be written; an older list
        is then unchanged, but some of its files may be replaced
*/
template <class Complex>
void write_PVTU(const std::string& path,
                const Deformable_simplicial_complexes::Distributed_complex<Complex>& complex) {
  namespace DSC = Deformable_simplicial_complexes;
  const auto& mesh = complex.mesh();
  static constexpr int d = Complex::dimension;
  std::vector<std::int64_t> number(mesh.piece.vertex_bound(), -1), connectivity;
  std::vector<typename Complex::Point> points;
  std::vector<std::int32_t> labels;
  std::vector<double> qualities;
  for (std::uint32_t c : mesh.own_cells()) {
    for (auto v : mesh.piece.cell(c).vertices) {
      if (number[v] < 0) {
        number[v] = std::int64_t(points.size());
        points.push_back(mesh.normalization.in_user_coordinates(mesh.position(v)));
      }
      connectivity.push_back(number[v]);
    }
    labels.push_back(mesh.piece.cell(c).data.label);
    qualities.push_back(mesh.quality(c));
  }
  DSC::internal::Vtu_document document(points.size(), labels.size());
  document.begin("CellData");
  document.array("label", labels);
  document.array("quality", qualities);
  document.array("rank", std::vector<std::int32_t>(labels.size(), mesh.rank()));
  document.end("CellData");
  document.points(points);
  document.cells(connectivity, DSC::internal::vtu_simplex(d));
  DSC::internal::write_pieces(path, complex.communicator(), document,
                              "      <PDataArray type=\"Int32\" Name=\"label\"/>\n"
                              "      <PDataArray type=\"Float64\" Name=\"quality\"/>\n"
                              "      <PDataArray type=\"Int32\" Name=\"rank\"/>\n");
}

/*!
\ingroup PkgDistributedComplexesRef

Writes the interface of a distributed complex for ParaView, as `write_PVTU()` writes the cells. The
cell data are `label_pair`, the larger and the smaller label, and `rank`. Normals point out of the
larger label. Collective.

\param path name of the list, with the extension `.pvtu`; its folder must exist
\param complex the complex
\throws Deformable_simplicial_complexes::Error on all ranks if a file cannot be written
*/
template <class Complex>
void write_interface_PVTU(
    const std::string& path,
    const Deformable_simplicial_complexes::Distributed_complex<Complex>& complex) {
  namespace DSC = Deformable_simplicial_complexes;
  const auto& mesh = complex.mesh();
  const auto interface_ = complex.interface_here();
  std::vector<std::int64_t> number(interface_.positions.size(), -1), connectivity;
  std::vector<typename Complex::Point> points;
  std::vector<std::int32_t> label_pairs;
  for (const auto& facet : interface_.snapshot.facets()) {
    if (!complex.owns(interface_, facet))
      continue;
    for (std::size_t v : facet.vertices) {
      if (number[v] < 0) {
        number[v] = std::int64_t(points.size());
        points.push_back(mesh.normalization.in_user_coordinates(interface_.positions[v]));
      }
      connectivity.push_back(number[v]);
    }
    label_pairs.push_back(facet.behind);
    label_pairs.push_back(facet.in_front);
  }
  const std::size_t facets = label_pairs.size() / 2;
  DSC::internal::Vtu_document document(points.size(), facets);
  document.begin("CellData");
  document.array("label_pair", label_pairs, 2);
  document.array("rank", std::vector<std::int32_t>(facets, mesh.rank()));
  document.end("CellData");
  document.points(points);
  document.cells(connectivity, DSC::internal::vtu_simplex(Complex::dimension - 1));
  DSC::internal::write_pieces(
      path, complex.communicator(), document,
      "      <PDataArray type=\"Int32\" Name=\"label_pair\" NumberOfComponents=\"2\"/>\n"
      "      <PDataArray type=\"Int32\" Name=\"rank\"/>\n");
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_DISTRIBUTED_COMPLEXES_PVTU_H
