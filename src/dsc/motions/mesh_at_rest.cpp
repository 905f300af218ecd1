// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "motions/mesh_at_rest.h"

#include "input/cell_regions.h"
#include "input/files.h"
#include "motions/tracked_complex.h"
#include "output/complex_output_3.h"
#include "programs/errors.h"

#include <CGAL/Complex_construction/assign_solid_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/Any_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>
#include <CGAL/Deformable_simplicial_complexes/Solid_domain.h>
#include <CGAL/Deformable_simplicial_complexes/internal/parts/assign_part.h>
#include <CGAL/Interface_remeshing/Carried_cell_averages.h>
#include <CGAL/Interface_remeshing/Carried_vertex_values.h>
#include <CGAL/Interface_remeshing/Number_rows.h>
#include <CGAL/Interface_remeshing/improve_mesh.h>
#include <CGAL/Mesh_files/MEDIT_3.h>
#include <CGAL/Mesh_files/VTU_3.h>
#include <CGAL/Mesh_files/internal/grids/Written_vertices.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

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
      return c->label() != n->label() || (m_listed[c->id()] >> i & 1) != 0 || m_is_alone[c->id()] ||
             m_is_alone[n->id()] ||
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
    CGAL::Deformable_simplicial_complexes::Progress_scope::check();
    for (const Cell_handle c : cells_around(m_complex, triangle)) {
      int sum = 6; // sum of the indices of all four vertices
      for (const Vertex_handle v : triangle)
        sum -= c->index(v);
      m_listed[c->id()] |= static_cast<std::uint8_t>(1 << sum);
    }
  }

  template <std::size_t n>
  void hold(const std::array<Vertex_handle, n>& simplex, const Cell_regions<Complex>& coarse) {
    CGAL::Deformable_simplicial_complexes::Progress_scope::check();
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

/// The numbers of all arrays at a vertex or cell.
using Content_row = DSC::Number_row;
template <class Handle> using Content_map = DSC::Number_row_map<Handle>;

/// A visitor that transfers the arrays and entities of a mesh through the changes of a complex.
/// Arrays of floating-point numbers are averages over cells, whose integrals are conserved, or
/// values at vertices, which are interpolated. A new vertex gets the integers of the nearest vertex
/// around it. Integers of cells are not transferred: see `Separation`.
template <class Complex> class Content_visitor : public DSC::Deformation_visitor
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;

  Content_visitor(const Complex& complex, const Mesh_content& content)
      : m_complex(complex), m_content(content), m_integers(complex.vertex_id_bound()),
        m_values(complex.vertex_id_bound()), m_cell_rows(complex.cell_id_bound()) {
    const std::vector<Vertex_handle> vertices = complex.vertices();
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Vertex_handle v = vertices[i];
      m_time_stamps.push_back(v->time_stamp());
      m_integers[v->id()] = row(content.arrays.points, true, i);
      m_values[v->id()] = row(content.arrays.points, false, i);
    }
    const std::vector<Cell_handle> cells = complex.cells();
    for (std::size_t i = 0; i < cells.size(); ++i)
      m_cell_rows[cells[i]->id()] = row(content.arrays.cells, false, i);
    if (!vertices.empty() && !m_values[vertices.front()->id()].numbers.empty())
      m_carried_values.emplace(complex, Content_map<Vertex_handle>{&m_values});
    if (!cells.empty() && !m_cell_rows[cells.front()->id()].numbers.empty())
      m_carried_averages.emplace(complex, Content_map<Cell_handle>{&m_cell_rows});
  }

  template <class Cavity> void before_replacement(const Cavity& cavity) {
    for_both([&](auto& carried) { carried.before_replacement(cavity); });
    m_new_integers.clear();
    for (std::size_t i = 0; i < cavity.vertices().size(); ++i)
      if (cavity.vertices()[i].handle == Vertex_handle())
        m_new_integers.emplace_back(i, integers_near(cavity, cavity.vertices()[i].position));
  }
  template <class Cavity> void after_replacement(const Cavity& cavity) {
    for_both([&](auto& carried) { carried.after_replacement(cavity); });
    for (auto& [i, integers] : m_new_integers)
      put(Content_map<Vertex_handle>{&m_integers}, cavity.vertices()[i].handle, integers);
  }
  template <class Star, class Point>
  void before_smoothing(Vertex_handle v, const Star& star, const Point& target) {
    for_both([&](auto& carried) { carried.before_smoothing(v, star, target); });
  }
  template <class Star> void after_smoothing(Vertex_handle v, const Star& star) {
    for_both([&](auto& carried) { carried.after_smoothing(v, star); });
  }

  /// Returns the content for the current vertices and cells. Must be called once, after all
  /// changes.
  /// \param row_of_cell for each cell, the row of an initial cell with the same integers
  Mesh_content finish(const std::vector<std::size_t>& row_of_cell) {
    m_carried_averages.reset(); // converts integrals into averages
    Mesh_content result = m_content;
    const std::vector<Vertex_handle> vertices = m_complex.vertices();
    take(result.arrays.points, true, m_integers, vertices);
    take(result.arrays.points, false, m_values, vertices);
    take(result.arrays.cells, false, m_cell_rows, m_complex.cells());
    for (Mesh_array& array : result.arrays.cells)
      if (array.is_integer())
        array = array.selected(row_of_cell);
    follow(result.entities, vertices);
    return result;
  }

private:
  template <class Call> void for_both(const Call& call) {
    if (m_carried_averages)
      call(*m_carried_averages);
    if (m_carried_values)
      call(*m_carried_values);
  }

  static Content_row row(const std::vector<Mesh_array>& arrays, bool of_integers, std::size_t i) {
    Content_row result;
    for (const Mesh_array& array : arrays)
      if (array.is_integer() == of_integers) {
        const auto begin = array.values.begin() + std::ptrdiff_t(i * array.components);
        result.numbers.insert(result.numbers.end(), begin,
                              begin + std::ptrdiff_t(array.components));
      }
    return result;
  }

  // Copies the numbers of the rows into the arrays.
  template <class Handle>
  static void take(std::vector<Mesh_array>& arrays, bool of_integers,
                   const std::vector<Content_row>& rows, const std::vector<Handle>& items) {
    std::size_t first = 0;
    for (Mesh_array& array : arrays) {
      if (array.is_integer() != of_integers)
        continue;
      array.values.clear();
      for (const Handle item : items) {
        const auto begin = rows[item->id()].numbers.begin() + std::ptrdiff_t(first);
        array.values.insert(array.values.end(), begin, begin + std::ptrdiff_t(array.components));
      }
      first += array.components;
    }
  }

  template <class Cavity, class Position>
  Content_row integers_near(const Cavity& cavity, const Position& p) const {
    Vertex_handle nearest;
    double least = 0;
    for (const auto& v : cavity.vertices()) {
      if (v.handle == Vertex_handle() || m_complex.is_infinite(v.handle))
        continue;
      const double distance = (v.position - p).squared_length();
      if (nearest == Vertex_handle() || distance < least) {
        least = distance;
        nearest = v.handle;
      }
    }
    return m_integers[nearest->id()];
  }

  // Updates vertex indices. New vertices get the reference 0; the vertices of entities still exist.
  void follow(Mesh_entities& entities, const std::vector<Vertex_handle>& vertices) const {
    std::vector<std::size_t> now(m_time_stamps.size(), 0);
    std::vector<int> references;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const auto it =
          std::lower_bound(m_time_stamps.begin(), m_time_stamps.end(), vertices[i]->time_stamp());
      const bool is_old = it != m_time_stamps.end() && *it == vertices[i]->time_stamp();
      const auto before = static_cast<std::size_t>(it - m_time_stamps.begin());
      if (is_old)
        now[before] = i;
      if (!entities.vertex_references.empty())
        references.push_back(is_old ? entities.vertex_references[before] : 0);
    }
    renumber_vertices(entities, now);
    entities.vertex_references = references;
  }

  const Complex& m_complex;
  const Mesh_content& m_content;
  std::vector<std::size_t> m_time_stamps;                     // time stamps of the initial vertices
  std::vector<Content_row> m_integers, m_values, m_cell_rows; // indexed by id
  std::vector<std::pair<std::size_t, Content_row>> m_new_integers; // by vertex of the cavity
  std::optional<DSC::Carried_cell_averages<Complex, Content_map<Cell_handle>>> m_carried_averages;
  std::optional<DSC::Carried_vertex_values<Complex, Content_map<Vertex_handle>>> m_carried_values;
};

// The quality measure depends on angles, because the complex does not move.
using Complex_at_rest =
    CGAL::Deformable_simplicial_complex_3<CGAL::Deformable_simplicial_complex_traits_3<>,
                                          CGAL::Default, DSC::Biased_minimum_sine_3,
                                          DSC::Solid_domain>;
using Cell_handle = Complex_at_rest::Cell_handle;
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

Mesh_at_rest::Mesh_at_rest(const std::string& path, Labeled_tetrahedra& mesh) {
  mesh.separate_touching_cells();
  try {
    m_vertices = DSC::assign_solid_3(m_complex, mesh.points, mesh.tetrahedra, mesh.labels);
  } catch (const DSC::Invalid_cells_error& error) {
    throw Input_error(path + ": " + error.what() + place_of(error, mesh));
  }
}

Mesh_content Mesh_at_rest::content(Labeled_tetrahedra mesh, Unused_content& unused) const {
  return content_of(std::move(mesh), m_complex, m_vertices, unused);
}

Statistics Mesh_at_rest::statistics() const {
  Statistics result = statistics_of(m_complex);
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
    Content_visitor<Complex_at_rest> visitor(at_rest, content);
    DSC::Visitor_adaptor<Complex_at_rest, Content_visitor<Complex_at_rest>> adaptor(visitor);
    improvement.visitor = &adaptor;
    outcome.changes = DSC::improve_mesh(at_rest, improvement);

    std::vector<std::size_t> row_of_cell;
    state = finite_state(at_rest.state());
    for (int& label : state.cell_labels) {
      row_of_cell.push_back(separation.row_of_region()[static_cast<std::size_t>(label)]);
      label = labels[row_of_cell.back()];
    }
    content = visitor.finish(row_of_cell);
    require_entities(at_rest, content.entities);
  }
  outcome.worst_after = least_quality(at_rest);
  // The failure counters belong to another quality measure.
  std::fill(state.failures.begin(), state.failures.end(), std::uint8_t(0));
  DSC::internal::classify_boundary(state);
  assign_part(m_complex, state);
  m_vertices.clear();
  leave_out_copies(content, m_complex);
  outcome.seconds = seconds_since(start);
  return outcome;
}

void Mesh_at_rest::write(const std::string& path) const { write_complex(path, m_complex); }

void Mesh_at_rest::write(const std::string& path, const Mesh_content& content) const {
  if (extension(path) == "vtu")
    CGAL::IO::write_VTU(path, m_complex, content.arrays);
  else
    CGAL::IO::write_MEDIT(path, m_complex, content.entities);
}

} // namespace dsc
