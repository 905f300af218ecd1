// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_INTERNAL_GRIDS_WRITE_VTU_H
#define CGAL_MESH_FILES_INTERNAL_GRIDS_WRITE_VTU_H

#include <CGAL/Interface_remeshing/internal/extraction/Extracted_facets.h>
#include <CGAL/Mesh_files/Mesh_arrays.h>
#include <CGAL/Mesh_files/internal/grids/Vtu_document.h>
#include <CGAL/Mesh_files/internal/grids/Written_vertices.h>
#include <CGAL/Mesh_files/replace_file.h>
#include <CGAL/Mesh_support/Progress_scope.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

constexpr Vtu_document::Cell_type vtu_simplex(int dimension) {
  return dimension == 3   ? Vtu_document::tetrahedron
         : dimension == 2 ? Vtu_document::triangle
                          : Vtu_document::line;
}

// Returns whether `write_cells_vtu()` always writes an array with this name.
inline bool is_computed_vtu_array(const std::string& name) {
  return name == "label" || name == "quality" || name == "boundary_class" || name == "interface";
}

// Writes all cells and given arrays. The arrays have a row for each vertex without copies, or for
// each cell, in the order of time stamps, which is also the order of the cells. On a flat torus, a
// cell that crosses the seam is written next to its first vertex, with additional images of its
// other vertices. Throws if the file cannot be written.
template <class Complex>
void write_cells_vtu(const std::string& path, const Complex& dsc, const Mesh_arrays& arrays) {
  using Vertex_handle = typename Complex::Vertex_handle;
  const Written_vertices<Complex> number(dsc);
  std::vector<typename Complex::Point> points; // in the frame of the complex
  std::vector<Vertex_handle> vertices = number.vertices();
  for (const auto v : vertices)
    points.push_back(dsc.position(v));
  std::vector<std::vector<std::size_t>> images(Complex::Domain::has_outside ? 0 : points.size());

  std::vector<std::int64_t> connectivity;
  std::vector<std::int32_t> labels;
  std::vector<double> qualities;
  for (const auto c : dsc.cells()) {
    Progress_scope::check();
    for (int i = 0; i < Complex::corners; ++i) {
      std::size_t index = number(c->vertex(i));
      if constexpr (!Complex::Domain::has_outside) {
        const auto p = dsc.corner(c, i);
        if (p != points[index]) {
          auto& further = images[index];
          std::size_t k = 0;
          while (k < further.size() && points[further[k]] != p)
            ++k;
          if (k == further.size()) {
            further.push_back(points.size());
            points.push_back(p);
            vertices.push_back(c->vertex(i));
          }
          index = further[k];
        }
      }
      connectivity.push_back(std::int64_t(index));
    }
    labels.push_back(dsc.label(c));
    qualities.push_back(dsc.quality(c));
  }
  std::vector<std::uint8_t> boundary_classes, interface_flags;
  for (const auto v : vertices) {
    boundary_classes.push_back(v->boundary_class());
    interface_flags.push_back(dsc.is_interface(v));
  }
  for (auto& p : points)
    p = dsc.in_user_coordinates(p);

  Vtu_document document(points.size(), labels.size());
  document.begin("PointData");
  document.array("boundary_class", boundary_classes);
  document.array("interface", interface_flags);
  std::vector<std::size_t> rows;
  for (const auto v : vertices)
    rows.push_back(number(v));
  for (const Mesh_array& array : arrays.points)
    if (!is_computed_vtu_array(array.name))
      document.array(array.selected(rows));
  document.end("PointData");
  document.begin("CellData");
  document.array("label", labels);
  document.array("quality", qualities);
  if (!arrays.labels.name.empty() && !is_computed_vtu_array(arrays.labels.name)) {
    Mesh_array given = arrays.labels;
    given.values.insert(given.values.end(), labels.begin(), labels.end());
    document.array(given);
  }
  for (const Mesh_array& array : arrays.cells)
    if (!is_computed_vtu_array(array.name))
      document.array(array);
  document.end("CellData");
  document.label_names(arrays.label_names);
  document.points(points);
  document.cells(connectivity, vtu_simplex(Complex::dimension));
  replace_file(path, [&](std::ostream& out) { document.write(out); });
}

// Writes all interface facets and given arrays. The arrays have a row for each vertex in the order
// of `dsc.interface_vertices()`, or for each facet in the order of `dsc.interface_facets()`.
template <class Complex>
void write_facets_vtu(const std::string& path, const Complex& dsc, const Mesh_arrays& arrays) {
  const Extracted_facets<Complex> interface_(dsc, dsc.interface_facets(), false);
  std::vector<std::int64_t> connectivity;
  for (const auto& facet : interface_.facets)
    connectivity.insert(connectivity.end(), facet.begin(), facet.end());
  std::vector<std::int32_t> label_pairs;
  for (const auto& pair : interface_.labels)
    label_pairs.insert(label_pairs.end(), pair.begin(), pair.end());

  Vtu_document document(interface_.points.size(), interface_.facets.size());
  if (!arrays.points.empty()) {
    const Vertex_numbers number(dsc, dsc.interface_vertices());
    std::vector<std::size_t> rows;
    for (const auto v : interface_.vertices)
      rows.push_back(number(v));
    document.begin("PointData");
    for (const Mesh_array& array : arrays.points)
      document.array(array.selected(rows));
    document.end("PointData");
  }
  document.begin("CellData");
  document.array("label_pair", label_pairs, 2);
  for (const Mesh_array& array : arrays.cells)
    if (array.name != "label_pair")
      document.array(array);
  document.end("CellData");
  document.label_names(arrays.label_names);
  document.points(interface_.points);
  document.cells(connectivity, vtu_simplex(Complex::dimension - 1));
  replace_file(path, [&](std::ostream& out) { document.write(out); });
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_FILES_INTERNAL_GRIDS_WRITE_VTU_H
