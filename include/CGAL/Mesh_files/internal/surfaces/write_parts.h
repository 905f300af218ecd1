// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Mesh_files, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MESH_FILES_INTERNAL_SURFACES_WRITE_PARTS_H
#define CGAL_MESH_FILES_INTERNAL_SURFACES_WRITE_PARTS_H

#include <CGAL/Mesh_files/Label_names.h>

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

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

// Returns the name of a part in one line.
inline std::string part_name(int label, const Label_names& names) {
  const auto name = names.find(label);
  std::string result = name == names.end() ? "label " + std::to_string(label) : name->second;
  std::replace_if(
      result.begin(), result.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
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

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_FILES_INTERNAL_SURFACES_WRITE_PARTS_H
