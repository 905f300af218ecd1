// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/labeled_tetrahedra.h"

#include "input/files.h"

#include <CGAL/Deformable_simplicial_complexes/internal/parts/assign_part.h>
#include <CGAL/Mesh_files/MEDIT_3.h>
#include <CGAL/Mesh_files/VTU_3.h>

namespace dsc {
namespace {

constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

/// Removes items and renumbers the others.
/// \param new_indices new index of each item; `none` for items to be removed
template <class Item>
void remove_items(std::vector<Item>& items, const std::vector<std::size_t>& new_indices) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < items.size(); ++i)
    if (new_indices[i] != none)
      items[n++] = items[i];
  items.resize(n);
}

/// Replaces indices by the new indices of their items. Returns the number of removed items.
std::size_t renumber(std::vector<std::size_t>& indices,
                     const std::vector<std::size_t>& new_indices) {
  const std::size_t before = indices.size();
  for (std::size_t& i : indices)
    i = new_indices[i];
  indices.erase(std::remove(indices.begin(), indices.end(), none), indices.end());
  return before - indices.size();
}

/// Renumbers the vertices of simplices and removes simplices with removed vertices. Returns the new
/// indices of the simplices.
template <std::size_t n>
std::vector<std::size_t> renumber(std::vector<Mesh_entities::Simplex<n>>& simplices,
                                  const std::vector<std::size_t>& new_vertices) {
  std::vector<std::size_t> result(simplices.size(), none);
  std::size_t number = 0;
  for (std::size_t i = 0; i < simplices.size(); ++i) {
    bool is_there = true;
    for (std::size_t& v : simplices[i].vertices)
      is_there = (v = new_vertices[v]) != none && is_there;
    if (is_there)
      result[i] = number++;
  }
  remove_items(simplices, result);
  return result;
}

void renumber(Mesh_entities& entities, const std::vector<std::size_t>& new_vertices,
              Unused_content& unused) {
  if (!entities.vertex_references.empty())
    remove_items(entities.vertex_references, new_vertices);
  const std::size_t edges = entities.edges.size(), triangles = entities.triangles.size();
  const auto new_edges = renumber(entities.edges, new_vertices);
  const auto new_triangles = renumber(entities.triangles, new_vertices);
  const auto add = [&](std::size_t number, const char* singular, const char* plural) {
    unused.add(noun(number, singular, plural) + std::string(" without a tetrahedron"), number);
  };
  add(edges - entities.edges.size(), "edge", "edges");
  add(triangles - entities.triangles.size(), "triangle", "triangles");
  add(renumber(entities.corners, new_vertices), "corner", "corners");
  add(renumber(entities.required_vertices, new_vertices), "required vertex", "required vertices");
  renumber(entities.ridges, new_edges);
  renumber(entities.required_edges, new_edges);
  renumber(entities.required_triangles, new_triangles);
}

// Files of other programs contain points of lines and surfaces, and points that are no longer used.
void remove_unused_points(Labeled_tetrahedra& mesh) {
  std::vector<std::size_t> new_indices(mesh.points.size(), none), rows;
  for (const auto& tetrahedron : mesh.tetrahedra)
    for (const std::size_t index : tetrahedron)
      new_indices[index] = 0;
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    if (new_indices[i] != none) {
      new_indices[i] = rows.size();
      rows.push_back(i);
    }
  if (rows.size() == mesh.points.size())
    return;
  const std::size_t unused_points = mesh.points.size() - rows.size();
  mesh.unused.add(
      noun(unused_points, "point without a tetrahedron", "points without a tetrahedron"),
      unused_points);
  remove_items(mesh.points, new_indices);
  for (auto& tetrahedron : mesh.tetrahedra)
    for (std::size_t& index : tetrahedron)
      index = new_indices[index];
  for (Mesh_array& array : mesh.arrays.points)
    array = array.selected(rows);
  renumber(mesh.entities, new_indices, mesh.unused);
}

/// Looks for the solution files that other programs store beside a mesh: values at vertices.
void look_for_solutions(const std::string& path, Unused_content& unused) {
  for (const char* extension : {".sol", ".solb"}) {
    const auto solutions = std::filesystem::path(path).replace_extension(extension);
    std::error_code error;
    if (std::filesystem::is_regular_file(solutions, error))
      unused.add("solution file (" + solutions.filename().string() + ')');
  }
}

using Tetrahedra = std::vector<std::array<std::size_t, 4>>;

/// Replaces the vertices of simplices as in a tetrahedron that contains the simplex.
/// \param before, after the tetrahedra with the previous and with the new vertices
template <std::size_t n>
void follow(std::vector<Mesh_entities::Simplex<n>>& simplices, const Tetrahedra& before,
            const Tetrahedra& after) {
  std::map<std::array<std::size_t, n>, std::size_t> tetrahedron_of; // by sorted vertices
  for (const auto& simplex : simplices) {
    auto key = simplex.vertices;
    std::sort(key.begin(), key.end());
    tetrahedron_of.emplace(key, none);
  }
  constexpr unsigned sets = 1 << 4; // of corners
  for (std::size_t t = 0; t < before.size() && !simplices.empty(); ++t)
    for (unsigned set = 0; set < sets; ++set) {
      std::array<std::size_t, n> key = {};
      std::size_t corners = 0;
      for (unsigned i = 0; i < 4; ++i)
        if ((set >> i & 1) != 0 && corners++ < n)
          key[corners - 1] = before[t][i];
      std::sort(key.begin(), key.end());
      if (const auto found = tetrahedron_of.find(key);
          corners == n && found != tetrahedron_of.end())
        found->second = t;
    }
  for (auto& simplex : simplices) {
    auto key = simplex.vertices;
    std::sort(key.begin(), key.end());
    if (const std::size_t t = tetrahedron_of[key]; t != none)
      for (std::size_t& v : simplex.vertices)
        v = after[t][std::size_t(std::find(before[t].begin(), before[t].end(), v) -
                                 before[t].begin())];
  }
}

} // namespace

void Labeled_tetrahedra::separate_touching_cells() {
  const Tetrahedra before = tetrahedra;
  const auto originals = DSC::internal::separate_touching_cells(points.size(), tetrahedra);
  if (originals.size() == points.size())
    return;
  for (std::size_t i = points.size(); i < originals.size(); ++i) {
    points.push_back(points[originals[i]]);
    if (!entities.vertex_references.empty())
      entities.vertex_references.push_back(entities.vertex_references[originals[i]]);
  }
  for (Mesh_array& array : arrays.points)
    array = array.selected(originals);
  follow(entities.edges, before, tetrahedra);
  follow(entities.triangles, before, tetrahedra);
}

void Labeled_tetrahedra::leave_out_arrays() {
  for (const Mesh_array& array : arrays.points)
    unused.add("point array (" + array.name + ')');
  for (const Mesh_array& array : arrays.cells)
    unused.add("cell array (" + array.name + ')');
  arrays.points.clear();
  arrays.cells.clear();
}

void Labeled_tetrahedra::leave_out_entities() {
  const auto add = [&](const auto& items, const char* singular, const char* plural) {
    unused.add(noun(items.size(), singular, plural), items.size());
  };
  add(entities.vertex_references, "vertex reference", "vertex references");
  add(entities.triangles, "triangle", "triangles");
  add(entities.edges, "edge", "edges");
  add(entities.corners, "corner", "corners");
  add(entities.required_vertices, "required vertex", "required vertices");
  add(entities.ridges, "ridge", "ridges");
  add(entities.required_edges, "required edge", "required edges");
  add(entities.required_triangles, "required triangle", "required triangles");
  entities = Mesh_entities();
}

Labeled_tetrahedra read_tetrahedra(const std::string& path, const std::string& label_array) {
  Labeled_tetrahedra mesh;
  if (extension(path) == "vtu") {
    try {
      CGAL::IO::read_VTU(path, mesh.points, mesh.tetrahedra, mesh.labels, label_array, &mesh.arrays,
                         &mesh.unused);
    } catch (const DSC::Label_array_error& error) {
      throw std::runtime_error(error.what() + std::string(" (--labels NAME)"));
    }
    // The names belong to the labels that this program and Gmsh write.
    if (const std::string& name = mesh.arrays.labels.name;
        name != "label" && name != "gmsh:physical") {
      const std::size_t names = std::exchange(mesh.arrays.label_names, {}).size();
      mesh.unused.add(noun(names, "name of a label", "names of labels"), names);
    }
  } else {
    CGAL::IO::read_MEDIT(path, mesh.points, mesh.tetrahedra, mesh.labels, &mesh.entities,
                         &mesh.unused);
    look_for_solutions(path, mesh.unused);
  }
  remove_unused_points(mesh);
  return mesh;
}

std::string place_of(const DSC::Invalid_cells_error& error, const Labeled_tetrahedra& mesh) {
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
