// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/mesh_content.h"

#include "input/cell_regions.h"
#include "programs/errors.h"

#include <CGAL/Mesh_files/internal/grids/write_vtu.h>
#include <CGAL/Mesh_support/Progress_scope.h>

namespace dsc {
namespace {

using Complex = Solid_complex;
using Vertex_handle = Complex::Vertex_handle;
using Cell_handle = Complex::Cell_handle;

/// Returns the indices of items, sorted by the key of each item.
template <class Key> std::vector<std::size_t> sorted_by(std::size_t size, const Key& key) {
  std::vector<std::size_t> result(size);
  std::iota(result.begin(), result.end(), std::size_t(0));
  std::sort(result.begin(), result.end(),
            [&](std::size_t i, std::size_t j) { return key(i) < key(j); });
  return result;
}

/// Returns, for each cell, the corresponding tetrahedron of the mesh.
/// \param vertices the vertices of the points of the mesh
std::vector<std::size_t> tetrahedra_of(const std::vector<Cell_handle>& cells,
                                       const std::vector<Vertex_handle>& vertices,
                                       const Labeled_tetrahedra& mesh) {
  using Corners = std::array<std::size_t, 4>;
  std::vector<Corners> expected, given;
  for (const auto& tetrahedron : mesh.tetrahedra) {
    given.emplace_back();
    for (std::size_t i = 0; i < 4; ++i)
      given.back()[i] = vertices[tetrahedron[i]]->time_stamp();
    std::sort(given.back().begin(), given.back().end());
  }
  for (const Cell_handle c : cells) {
    expected.emplace_back();
    for (int i = 0; i < 4; ++i)
      expected.back()[std::size_t(i)] = c->vertex(i)->time_stamp();
    std::sort(expected.back().begin(), expected.back().end());
  }
  const auto sorted_cells = sorted_by(cells.size(), [&](std::size_t i) { return expected[i]; });
  const auto sorted_given = sorted_by(given.size(), [&](std::size_t i) { return given[i]; });
  std::vector<std::size_t> result(cells.size());
  for (std::size_t k = 0; k < cells.size(); ++k)
    result[sorted_cells[k]] = sorted_given[k];
  return result;
}

/// Removes simplices that are not in the complex. Returns their number.
template <std::size_t n>
std::size_t remove_foreign(std::vector<Mesh_entities::Simplex<n>>& simplices,
                           const std::vector<std::vector<std::size_t>*>& lists,
                           const std::vector<Vertex_handle>& vertices, const Complex& complex) {
  std::vector<std::size_t> new_index(simplices.size());
  std::vector<bool> is_foreign(simplices.size(), false);
  std::size_t number = 0;
  for (std::size_t i = 0; i < simplices.size(); ++i) {
    DSC::Progress_scope::check();
    new_index[i] = number;
    is_foreign[i] = cells_around(complex, handles(vertices, simplices[i].vertices)).empty();
    if (!is_foreign[i])
      simplices[number++] = simplices[i];
  }
  const std::size_t removed = simplices.size() - number;
  simplices.resize(number);
  for (std::vector<std::size_t>* list : lists) {
    list->erase(
        std::remove_if(list->begin(), list->end(), [&](std::size_t i) { return is_foreign[i]; }),
        list->end());
    for (std::size_t& i : *list)
      i = new_index[i];
  }
  return removed;
}

/// Returns whether an array contains the numbers 0, 1, ... or 1, 2, ... in any order. Arrays with
/// few rows are not taken for numbers.
bool is_numbering(const Mesh_array& array) {
  static constexpr std::size_t few = 16;
  if (!array.is_integer() || array.components != 1 || array.rows() <= few)
    return false;
  const double first = *std::min_element(array.values.begin(), array.values.end());
  std::vector<bool> is_present(array.rows(), false);
  for (const double value : array.values) {
    const auto i = static_cast<std::size_t>(value - first);
    if (i >= is_present.size() || is_present[i])
      return false;
    is_present[i] = true;
  }
  return first == 0 || first == 1;
}

/// Returns whether `write_VTU()` always writes an array of this name.
bool is_computed(const Mesh_array& array) {
  return DSC::internal::is_computed_vtu_array(array.name);
}

/// Returns whether all computed arrays are present: the file was written by this package.
bool has_computed_arrays(const Mesh_arrays& arrays) {
  const auto number = std::count_if(arrays.points.begin(), arrays.points.end(), is_computed) +
                      std::count_if(arrays.cells.begin(), arrays.cells.end(), is_computed);
  return arrays.labels.name == "label" && number == 3;
}

template <class Is_unfit>
void remove_arrays(std::vector<Mesh_array>& arrays, const std::string& reason,
                   Unused_content* unused, const Is_unfit& is_unfit) {
  const auto remove = [&](const Mesh_array& array) {
    const bool result = is_unfit(array);
    if (result && unused != nullptr)
      unused->add("array " + reason + " ('" + array.name + "')");
    return result;
  };
  arrays.erase(std::remove_if(arrays.begin(), arrays.end(), remove), arrays.end());
}

} // namespace

bool Mesh_content::is_empty() const {
  return arrays.points.empty() && arrays.cells.empty() && entities.vertex_references.empty() &&
         entities.edges.empty() && entities.triangles.empty() && entities.corners.empty() &&
         entities.required_vertices.empty();
}

Mesh_arrays carried_arrays(Mesh_arrays arrays, Unused_content& unused) {
  Unused_content* const told = has_computed_arrays(arrays) ? nullptr : &unused;
  for (auto* list : {&arrays.points, &arrays.cells})
    remove_arrays(*list, "that is computed again", told, is_computed);
  remove_arrays(arrays.points, "of point numbers, which change", &unused, is_numbering);
  remove_arrays(arrays.cells, "of cell numbers, which change", &unused, is_numbering);
  return arrays;
}

Mesh_content content_of(Labeled_tetrahedra mesh, const Complex& complex,
                        const std::vector<Vertex_handle>& vertices_of_points,
                        const std::string& format, Unused_content& unused) {
  if (format != "vtu")
    mesh.leave_out_arrays();
  if (format != "mesh")
    mesh.leave_out_entities();
  unused.add(mesh.unused);
  Mesh_content content{carried_arrays(std::move(mesh.arrays), unused), std::move(mesh.entities)};
  if (content.is_empty())
    return content;

  const std::vector<Vertex_handle> vertices = complex.vertices();
  const std::vector<Cell_handle> cells = complex.cells();
  std::vector<std::size_t> index_of_vertex(complex.vertex_id_bound()), points(vertices.size()),
      vertex_of_point;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    index_of_vertex[vertices[i]->id()] = i;
  for (const Vertex_handle v : vertices_of_points) {
    points[index_of_vertex[v->id()]] = vertex_of_point.size();
    vertex_of_point.push_back(index_of_vertex[v->id()]);
  }
  const std::vector<std::size_t> tetrahedra = tetrahedra_of(cells, vertices_of_points, mesh);
  for (Mesh_array& array : content.arrays.points)
    array = array.selected(points);
  for (Mesh_array& array : content.arrays.cells)
    array = array.selected(tetrahedra);

  Mesh_entities& entities = content.entities;
  const std::vector<int> references = entities.vertex_references;
  for (std::size_t i = 0; i < references.size(); ++i)
    entities.vertex_references[i] = references[points[i]];
  renumber_vertices(entities, vertex_of_point);
  const std::size_t triangles =
      remove_foreign(entities.triangles, {&entities.required_triangles}, vertices, complex);
  unused.add(noun(triangles, "triangle without a tetrahedron", "triangles without a tetrahedron"),
             triangles);
  const std::size_t edges = remove_foreign(
      entities.edges, {&entities.ridges, &entities.required_edges}, vertices, complex);
  unused.add(noun(edges, "edge without a tetrahedron", "edges without a tetrahedron"), edges);
  return content;
}

void renumber_vertices(Mesh_entities& entities, const std::vector<std::size_t>& new_indices) {
  const auto renumber = [&](auto& indices) {
    for (std::size_t& v : indices)
      v = new_indices[v];
  };
  for (auto& edge : entities.edges)
    renumber(edge.vertices);
  for (auto& triangle : entities.triangles)
    renumber(triangle.vertices);
  renumber(entities.corners);
  renumber(entities.required_vertices);
}

} // namespace dsc
