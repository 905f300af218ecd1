// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "labelled_tetrahedra.h"

#include "files.h"

#include <CGAL/IO/MEDIT_3.h>
#include <CGAL/IO/VTU_3.h>

#include <limits>
#include <sstream>

namespace dsc {
namespace {

// Other programs write points of lines and surfaces, or those that they once had a use for.
void remove_unused_points(Labelled_tetrahedra& mesh) {
  constexpr std::size_t unused = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> new_indices(mesh.points.size(), unused);
  for (const auto& tetrahedron : mesh.tetrahedra)
    for (const std::size_t index : tetrahedron)
      new_indices[index] = 0;
  std::size_t n = 0;
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    if (new_indices[i] != unused) {
      mesh.points[n] = mesh.points[i];
      new_indices[i] = n++;
    }
  mesh.points.resize(n);
  for (auto& tetrahedron : mesh.tetrahedra)
    for (std::size_t& index : tetrahedron)
      index = new_indices[index];
}

} // namespace

Labelled_tetrahedra read_tetrahedra(const std::string& path) {
  Labelled_tetrahedra mesh;
  if (extension(path) == "vtu")
    CGAL::IO::read_VTU(path, mesh.points, mesh.tetrahedra, mesh.labels);
  else
    CGAL::IO::read_MEDIT(path, mesh.points, mesh.tetrahedra, mesh.labels);
  remove_unused_points(mesh);
  return mesh;
}

std::string place_of(const CGAL::Deformable_simplicial_complexes::Invalid_tetrahedra_error& error,
                     const Labelled_tetrahedra& mesh) {
  std::vector<std::size_t> corners = error.vertices();
  if (!error.tetrahedra().empty()) {
    const auto& tetrahedron = mesh.tetrahedra[error.tetrahedra().front()];
    corners.assign(tetrahedron.begin(), tetrahedron.end());
  }
  if (corners.empty())
    return "";
  std::ostringstream text;
  text << " (";
  if (error.tetrahedra().size() > 1)
    text << error.tetrahedra().size() << " tetrahedra, the first ";
  const auto& corner = mesh.points[corners.front()];
  text << "at the point " << corner.x() << ' ' << corner.y() << ' ' << corner.z() << ')';
  return text.str();
}

} // namespace dsc
