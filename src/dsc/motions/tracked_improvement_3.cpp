// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/cell_regions.h"
#include "input/files.h"
#include "input/mesh_content.h"
#include "motions/tracked_complex_3.h"
#include "output/label_titles.h"
#include "programs/errors.h"

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/Any_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>
#include <CGAL/Interface_remeshing/Carried_cell_averages.h>
#include <CGAL/Interface_remeshing/Carried_vertex_values.h>
#include <CGAL/Interface_remeshing/Number_rows.h>
#include <CGAL/Interface_remeshing/improve_mesh.h>
#include <CGAL/Mesh_files/MEDIT_3.h>
#include <CGAL/Mesh_files/VTU_3.h>
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
                                          CGAL::Default, DSC::Biased_minimum_sine_3>;
using Cell_handle = Complex_at_rest::Cell_handle;
using State = DSC::State<3>;

double least_quality(const Complex_at_rest& complex) {
  double result = 1;
  for (const Cell_handle c : complex.cells())
    result = std::min(result, complex.quality(c));
  return result;
}

/// Calls `f(i, k)` for the k-th finite cell of a state, which has index i.
template <class Function> void for_each_finite_cell(const State& state, const Function& f) {
  std::size_t k = 0;
  for (std::size_t i = 0; i < state.cells.size(); ++i)
    if (std::find(state.cells[i].begin(), state.cells[i].end(), 0u) == state.cells[i].end())
      f(i, k++);
}

/// Replaces the labels by regions, and fixes the boundary if necessary.
void separate(State& state, const Separation<Complex_at_rest>& separation) {
  for_each_finite_cell(state, [&](std::size_t i, std::size_t k) {
    state.cell_labels[i] = separation.region_of_row()[k];
    state.cell_components[i] = static_cast<std::uint32_t>(separation.region_of_row()[k]);
  });
  if (separation.needs_boundary())
    for (std::uint8_t& sides : state.boundary_classes)
      if (sides != DSC::Boundary_class::inside)
        sides = DSC::Boundary_class::fixed;
}

/// Returns the state of a complex with other labels of the cells.
State relabeled_state(const Complex_at_rest& complex, const std::vector<int>& labels) {
  const std::vector<Cell_handle> cells = complex.cells();
  std::vector<int> label_of_cell(complex.cell_id_bound());
  for (std::size_t k = 0; k < cells.size(); ++k)
    label_of_cell[cells[k]->id()] = labels[k];
  const Cell_regions<Complex_at_rest> components(complex, [&](Cell_handle c, int i) {
    return label_of_cell[c->id()] != label_of_cell[c->neighbor(i)->id()];
  });
  State state = complex.state();
  for_each_finite_cell(state, [&](std::size_t i, std::size_t k) {
    state.cell_labels[i] = labels[k];
    state.cell_components[i] = static_cast<std::uint32_t>(components.of_cell[cells[k]->id()]);
  });
  return state;
}

std::vector<int> labels_by_time_stamp(const Complex_at_rest& complex) {
  std::vector<int> result;
  for (const Cell_handle c : complex.cells())
    result.push_back(c->label());
  return result;
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

Improvement_outcome Tracked_complex_3::improve(const Improvement_options& options,
                                               Mesh_content& content) {
  DSC::Mesh_improvement_options<Complex_at_rest> improvement;
  improvement.aggressive = options.aggressive;
  improvement.quality_threshold = options.threshold;
  improvement.number_of_threads = options.threads;
  const auto start = Clock::now();
  Complex_at_rest at_rest;
  State state = complex.state();
  at_rest.restore(state);
  Improvement_outcome outcome;
  outcome.worst_before = least_quality(at_rest);
  if (content.is_empty()) {
    outcome.changes = DSC::improve_mesh(at_rest, improvement);
    state = at_rest.state();
  } else {
    const std::vector<int> labels = labels_by_time_stamp(at_rest);
    const Separation<Complex_at_rest> separation(at_rest, content);
    separate(state, separation);
    at_rest.restore(state);
    Content_visitor<Complex_at_rest> visitor(at_rest, content);
    DSC::Visitor_adaptor<Complex_at_rest, Content_visitor<Complex_at_rest>> adaptor(visitor);
    improvement.visitor = &adaptor;
    outcome.changes = DSC::improve_mesh(at_rest, improvement);

    std::vector<std::size_t> row_of_cell;
    std::vector<int> new_labels;
    for (const Cell_handle c : at_rest.cells()) {
      row_of_cell.push_back(separation.row_of_region()[static_cast<std::size_t>(c->label())]);
      new_labels.push_back(labels[row_of_cell.back()]);
    }
    content = visitor.finish(row_of_cell);
    require_entities(at_rest, content.entities);
    if (separation.needs_boundary())
      at_rest.domain().classify_boundary(at_rest);
    state = relabeled_state(at_rest, new_labels);
  }
  outcome.worst_after = least_quality(at_rest);
  // The failure counters belong to another quality measure.
  std::fill(state.failures.begin(), state.failures.end(), std::uint8_t(0));
  complex.restore(state);
  outcome.seconds = seconds_since(start);
  return outcome;
}

void Tracked_complex_3::write(const std::string& path, const Mesh_content& content) const {
  tell_lost_names(path, label_names);
  if (extension(path) == "vtu")
    CGAL::IO::write_VTU(path, complex, content.arrays);
  else
    CGAL::IO::write_MEDIT(path, complex, content.entities);
}

} // namespace dsc
