// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "motions/mesh_at_rest.h"

#include "input/cell_regions.h"
#include "input/files.h"
#include "motions/array_visitor.h"
#include "motions/tracked_complex.h"
#include "output/complex_output_3.h"
#include "programs/errors.h"

#include <CGAL/Complex_construction/assign_solid_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/internal/parts/assign_part.h>
#include <CGAL/Interface_remeshing/improve_mesh.h>
#include <CGAL/Mesh_files/MEDIT_3.h>
#include <CGAL/Mesh_files/internal/grids/Written_vertices.h>
#include <CGAL/Mesh_support/Progress_scope.h>

namespace dsc {
namespace {

/// A partition of the cells into regions. Edges, triangles and vertices that must not change lie
/// between regions, or on the boundary of the domain. If labels are replaced by regions, mesh
/// improvement preserves these simplices as it preserves the interface.
///
/// The cells of a region have the same label and the same values in all arrays of integers, and no
/// listed triangle is between them. If a simplex is still inside a region, for example a triangle
/// that ends inside the region, a cell around it becomes a separate region.
template <class Complex> class Separation
{
public:
  using Cell_handle = typename Complex::Cell_handle;
  using Vertex_handle = typename Complex::Vertex_handle;

  Separation(const Complex& complex, const Mesh_content& content)
      : m_complex(complex), m_cells(complex.cells()), m_row(complex.cell_id_bound()),
        m_listed(complex.cell_id_bound(), 0), m_is_alone(complex.cell_id_bound(), false) {
    for (std::size_t i = 0; i < m_cells.size(); ++i)
      m_row[m_cells[i]->id()] = i;
    for (const Mesh_array& array : content.arrays.cells)
      if (array.is_integer())
        m_categories.push_back(&array);
    const std::vector<Vertex_handle> vertices = complex.vertices();
    for (const auto& triangle : content.entities.triangles)
      mark(handles(vertices, triangle.vertices));

    const Cell_regions<Complex> coarse = regions();
    for (const auto& triangle : content.entities.triangles)
      hold(handles(vertices, triangle.vertices), coarse);
    for (const auto& edge : content.entities.edges)
      hold(handles(vertices, edge.vertices), coarse);
    for (const auto* list : {&content.entities.corners, &content.entities.required_vertices})
      for (const std::size_t v : *list)
        hold(std::array<Vertex_handle, 1>{vertices[v]}, coarse);
    tell_results(regions());
  }

  /// Returns whether a simplex lies on the boundary of the domain only, and not between regions.
  bool needs_boundary() const { return m_needs_boundary; }

  /// Returns the region of each cell, by increasing time stamp.
  const std::vector<int>& region_of_row() const { return m_region_of_row; }

  /// Returns, for each region, the index of one of its cells by increasing time stamp.
  const std::vector<std::size_t>& row_of_region() const { return m_row_of_region; }

private:
  Cell_regions<Complex> regions() const {
    return Cell_regions<Complex>(m_complex, [&](Cell_handle c, int i) {
      const Cell_handle n = c->neighbor(i);
      return c->subdomain_index() != n->subdomain_index() || (m_listed[c->id()] >> i & 1) != 0 ||
             m_is_alone[c->id()] || m_is_alone[n->id()] ||
             std::any_of(m_categories.begin(), m_categories.end(),
                         [&](const Mesh_array* array) { return differs(*array, c, n); });
    });
  }

  bool differs(const Mesh_array& array, Cell_handle a, Cell_handle b) const {
    const std::size_t i = m_row[a->id()] * array.components, j = m_row[b->id()] * array.components;
    for (std::size_t k = 0; k < array.components; ++k)
      if (array.values[i + k] != array.values[j + k])
        return true;
    return false;
  }

  void mark(const std::array<Vertex_handle, 3>& triangle) {
    DSC::Progress_scope::check();
    for (const Cell_handle c : cells_around(m_complex, triangle)) {
      int sum = 6; // sum of the indices of all four vertices
      for (const Vertex_handle v : triangle)
        sum -= c->index(v);
      m_listed[c->id()] |= static_cast<std::uint8_t>(1 << sum);
    }
  }

  template <std::size_t n>
  void hold(const std::array<Vertex_handle, n>& simplex, const Cell_regions<Complex>& coarse) {
    DSC::Progress_scope::check();
    auto around = cells_around(m_complex, simplex);
    const auto inside = std::partition(around.begin(), around.end(),
                                       [&](Cell_handle c) { return m_complex.is_infinite(c); });
    const auto lies_between = [&](Cell_handle c) {
      const auto first = (*inside)->id();
      return c->id() != first && (m_is_alone[c->id()] || m_is_alone[first] ||
                                  coarse.of_cell[c->id()] != coarse.of_cell[first]);
    };
    if (std::any_of(inside, around.end(), lies_between))
      return;
    if (inside != around.begin()) {
      m_needs_boundary = true;
      return;
    }
    // Separates the cell of best quality, because cells of low quality must be improved.
    const auto best = std::min_element(inside, around.end(), [](Cell_handle a, Cell_handle b) {
      return std::make_pair(-a->quality(), a->time_stamp()) <
             std::make_pair(-b->quality(), b->time_stamp());
    });
    m_is_alone[(*best)->id()] = true;
  }

  void tell_results(const Cell_regions<Complex>& fine) {
    m_row_of_region.resize(static_cast<std::size_t>(fine.number));
    for (std::size_t i = m_cells.size(); i-- > 0;) {
      m_row_of_region[static_cast<std::size_t>(fine.of_cell[m_cells[i]->id()])] = i;
      m_region_of_row.push_back(fine.of_cell[m_cells[i]->id()]);
    }
    std::reverse(m_region_of_row.begin(), m_region_of_row.end());
  }

  const Complex& m_complex;
  std::vector<Cell_handle> m_cells;
  std::vector<std::size_t> m_row;              // row of each cell, by id
  std::vector<const Mesh_array*> m_categories; // arrays of integers
  std::vector<std::uint8_t> m_listed;          // bits of the facets that are listed triangles
  std::vector<bool> m_is_alone;                // cells that are separate regions
  std::vector<int> m_region_of_row;
  std::vector<std::size_t> m_row_of_region;
  bool m_needs_boundary = false;
};

// The quality measure depends on angles, because the complex does not move.
using Complex_at_rest =
    CGAL::Deformable_simplicial_complex_3<CGAL::Epick, CGAL::Default, DSC::Biased_minimum_sine_3,
                                          DSC::Solid_domain>;
using Cell_handle = Complex_at_rest::Cell_handle;

/// Updates the vertex indices of entities after changes of a complex. New vertices get the
/// reference 0; the vertices of entities still exist.
/// \param time_stamps of the vertices before the changes
void follow(const Complex_at_rest& complex, const std::vector<std::size_t>& time_stamps,
            Mesh_entities& entities) {
  const std::vector<Complex_at_rest::Vertex_handle> vertices = complex.vertices();
  std::vector<std::size_t> now(time_stamps.size(), 0);
  std::vector<int> references;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto it =
        std::lower_bound(time_stamps.begin(), time_stamps.end(), vertices[i]->time_stamp());
    const bool is_old = it != time_stamps.end() && *it == vertices[i]->time_stamp();
    const auto before = static_cast<std::size_t>(it - time_stamps.begin());
    if (is_old)
      now[before] = i;
    if (!entities.vertex_references.empty())
      references.push_back(is_old ? entities.vertex_references[before] : 0);
  }
  renumber_vertices(entities, now);
  entities.vertex_references = references;
}

using State = DSC::State<3>;
using DSC::internal::assign_part;
using DSC::internal::finite_state;

/// Replaces the labels by regions, and fixes the boundary if necessary.
void separate(State& state, const Separation<Complex_at_rest>& separation) {
  state.cell_labels.assign(separation.region_of_row().begin(), separation.region_of_row().end());
  if (separation.needs_boundary())
    for (std::uint8_t& sides : state.boundary_classes)
      if (sides != DSC::Boundary_class::inside)
        sides = DSC::Boundary_class::fixed;
}

/// Leaves out the rows of copies of vertices, as files do.
void leave_out_copies(Mesh_content& content, const Solid_complex& complex) {
  const DSC::internal::Written_vertices<Solid_complex> written(complex);
  const auto vertices = complex.vertices();
  std::vector<std::size_t> rows, numbers;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    numbers.push_back(written(vertices[i]));
    if (written.vertices()[numbers.back()] == vertices[i])
      rows.push_back(i);
  }
  for (Mesh_array& array : content.arrays.points)
    array = array.selected(rows);
  const std::vector<int> references = content.entities.vertex_references;
  content.entities.vertex_references.clear();
  for (std::size_t k = 0; k < rows.size() && !references.empty(); ++k)
    content.entities.vertex_references.push_back(references[rows[k]]);
  renumber_vertices(content.entities, numbers);
}

/// Checks that all entities still exist after the improvement.
void require_entities(const Complex_at_rest& complex, const Mesh_entities& entities) {
  const auto vertices = complex.vertices();
  const auto require = [&](const auto& simplices, const char* name) {
    for (const auto& simplex : simplices)
      if (cells_around(complex, handles(vertices, simplex.vertices)).empty())
        throw Input_error(std::string("cannot preserve all ") + name +
                          " of the mesh; remove them from the input");
  };
  require(entities.edges, "edges");
  require(entities.triangles, "triangles");
}

} // namespace

Mesh_at_rest::Mesh_at_rest(const std::string& path, Labeled_tetrahedra& mesh)
    : m_names(mesh.arrays.label_names) {
  mesh.separate_touching_cells();
  try {
    m_vertices = DSC::assign_solid_3(m_complex, mesh.points, mesh.tetrahedra, mesh.labels);
  } catch (const DSC::Invalid_cells_error& error) {
    throw Input_error(path + ": " + error.what() + place_of(error, mesh));
  }
}

Mesh_at_rest::Mesh_at_rest(const State& state, const Label_names& names) : m_names(names) {
  assign_part(m_complex, finite_state(state));
}

Mesh_content Mesh_at_rest::content(Labeled_tetrahedra mesh, const std::string& format,
                                   Unused_content& unused) const {
  return content_of(std::move(mesh), m_complex, m_vertices, format, unused);
}

Statistics Mesh_at_rest::statistics() const {
  Statistics result = statistics_of(m_complex, m_names);
  result.vertices = DSC::internal::Written_vertices<Solid_complex>(m_complex).vertices().size();
  return result;
}

Improvement_outcome Mesh_at_rest::improve(const Improvement_options& options,
                                          Mesh_content& content) {
  DSC::Mesh_improvement_options<Complex_at_rest> improvement;
  improvement.aggressive = options.aggressive;
  improvement.quality_threshold = options.threshold;
  improvement.number_of_threads = options.threads;
  const auto start = Clock::now();
  Complex_at_rest at_rest;
  State state = finite_state(m_complex.state());
  assign_part(at_rest, state);
  Improvement_outcome outcome;
  outcome.worst_before = least_quality(at_rest);
  if (content.is_empty()) {
    outcome.changes = DSC::improve_mesh(at_rest, improvement);
    state = finite_state(at_rest.state());
  } else {
    const std::vector<int> labels = state.cell_labels;
    const Separation<Complex_at_rest> separation(at_rest, content);
    separate(state, separation);
    assign_part(at_rest, state);
    std::vector<std::size_t> time_stamps;
    for (const auto v : at_rest.vertices())
      time_stamps.push_back(v->time_stamp());
    Array_visitor<Complex_at_rest> visitor(at_rest, content.arrays);
    improvement.visitor = &visitor;
    outcome.changes = DSC::improve_mesh(at_rest, improvement);

    state = finite_state(at_rest.state());
    for (int& label : state.cell_labels)
      label = labels[separation.row_of_region()[static_cast<std::size_t>(label)]];
    content.arrays = visitor.finish();
    follow(at_rest, time_stamps, content.entities);
    require_entities(at_rest, content.entities);
  }
  outcome.worst_after = least_quality(at_rest);
  // The failure counters belong to another quality measure.
  std::fill(state.failures.begin(), state.failures.end(), std::uint8_t(0));
  DSC::internal::classify_boundary(state);
  assign_part(m_complex, state);
  m_vertices.clear();
  outcome.seconds = seconds_since(start);
  return outcome;
}

void Mesh_at_rest::write(const std::string& path, Mesh_content content) const {
  leave_out_copies(content, m_complex);
  content.arrays.label_names = m_names;
  if (extension(path) != "mesh")
    return write_complex(path, m_complex, content.arrays);
  tell_lost_names(path, m_names);
  CGAL::IO::write_MEDIT(path, m_complex, content.entities);
}

} // namespace dsc
