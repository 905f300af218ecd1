// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cell_regions.h"
#include "content_visitor.h"
#include "errors.h"
#include "files.h"
#include "separation.h"
#include "tracked_complex_3.h"

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>
#include <CGAL/Deformable_simplicial_complexes/IO/MEDIT_3.h>
#include <CGAL/Deformable_simplicial_complexes/IO/VTU_3.h>
#include <CGAL/Deformable_simplicial_complexes/improve_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc {
namespace {

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
  if (extension(path) == "vtu")
    CGAL::IO::write_VTU(path, complex, content.arrays);
  else
    CGAL::IO::write_MEDIT(path, complex, content.entities);
}

} // namespace dsc
