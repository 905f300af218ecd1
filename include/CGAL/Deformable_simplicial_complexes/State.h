// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_STATE_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_STATE_H

#include <CGAL/Mesh_support/coordinates.h>
#include <CGAL/Mesh_support/internal/numbers/Extent.h>

#include <tuple>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

The state of a deformable simplicial complex, as plain numbers. A complex restored from its state
continues with bitwise equal results. This requires more than points and cells. Simplices are
visited in their order. The walk around a vertex begins at the cell stored with it. Terms of a cell
are summed in the order of its vertices.

States are returned by `Labeled_complex::state()` and restored by `Labeled_complex::restore()`.
Coordinates and lengths are those of the complex, not of the user, see
`Labeled_complex::Normalization`.

\tparam d the dimension
*/
template <int d> struct State
{
  /// coordinates of the finite vertices, by increasing time stamp
  std::vector<std::array<double, d>> points;

  /// boundary classes of the finite vertices
  std::vector<std::uint8_t> boundary_classes;

  /// `spacing()` of each finite vertex
  std::vector<float> spacings;

  /// index in `cells` of the cell stored with each vertex: first for the infinite vertex, if there
  /// is one, then for the finite ones
  std::vector<std::uint32_t> vertex_cells;

  /// vertices of all cells, including infinite ones, by increasing time stamp of the cell; 0 is the
  /// infinite vertex, `i + 1` is the vertex `i`
  std::vector<std::array<std::uint32_t, d + 1>> cells;

  /// labels of `cells`
  std::vector<std::int32_t> cell_labels;

  /// quality of each of `cells` at the last essential change of its shape
  std::vector<float> noted_qualities;

  /// failed attempts to improve each of `cells` since that change, as bits
  std::vector<std::uint8_t> failures;

  /// number of the component of each of `cells`, as used in events; 0 for infinite cells
  std::vector<std::uint32_t> cell_components;

  /// mean length of the interface edges when the complex was built
  double mean_interface_edge = 0;

  /// smallest length of an interface edge when the complex was built
  double minimum_interface_edge = 0;

  /// translation of the normalization
  std::array<double, d> normalization_translation = {};

  /// scale of the normalization
  double normalization_scale = 1;

  /// periods of the domain if it is a torus, which has no infinite vertex; otherwise 0
  std::array<double, d> periods = {};
};

namespace internal {

// Returns references to all members. All functions of states use this list only. The structured
// binding fails to compile if a member is missing.
template <class State_d> auto members(State_d& state) {
  auto& [points, boundary_classes, spacings, vertex_cells, cells, cell_labels, noted_qualities,
         failures, cell_components, mean_interface_edge, minimum_interface_edge,
         normalization_translation, normalization_scale, periods] = state;
  return std::tie(points, boundary_classes, spacings, vertex_cells, cells, cell_labels,
                  noted_qualities, failures, cell_components, mean_interface_edge,
                  minimum_interface_edge, normalization_translation, normalization_scale, periods);
}

// Returns whether parallel arrays have the same size.
template <int d> bool has_consistent_sizes(const State<d>& state) {
  const bool is_torus = state.periods != std::array<double, d>{};
  const std::size_t infinite = state.cells.empty() || is_torus ? 0 : 1;
  return state.boundary_classes.size() == state.points.size() &&
         state.spacings.size() == state.points.size() &&
         state.vertex_cells.size() == state.points.size() + infinite &&
         state.cell_labels.size() == state.cells.size() &&
         state.noted_qualities.size() == state.cells.size() &&
         state.failures.size() == state.cells.size() &&
         state.cell_components.size() == state.cells.size();
}

// Returns whether the arrays are consistent, all coordinates are finite, and the vertices of each
// cell differ.
template <int d> bool is_consistent(const State<d>& state) {
  const auto is_length = [](double length) { return length >= 0 && std::isfinite(length); };
  if (!has_consistent_sizes(state) || state.cells.size() >= std::uint32_t(-1) ||
      !(state.normalization_scale > 0) || !std::isfinite(state.normalization_scale) ||
      !is_length(state.mean_interface_edge) || !is_length(state.minimum_interface_edge) ||
      !std::all_of(state.spacings.begin(), state.spacings.end(), is_length))
    return false;
  // Without an infinite vertex, no cell has the vertex 0.
  const std::size_t first = state.points.size() + 1 - state.vertex_cells.size();
  const auto is_cell = [&](std::array<std::uint32_t, d + 1> c) {
    std::sort(c.begin(), c.end());
    return c[0] >= first && c[d] <= state.points.size() &&
           std::adjacent_find(c.begin(), c.end()) == c.end();
  };
  const auto is_cell_of = [&](std::size_t v) {
    const std::size_t c = state.vertex_cells[v], index = v + first;
    return c < state.cells.size() &&
           std::find(state.cells[c].begin(), state.cells[c].end(), index) != state.cells[c].end();
  };
  bool result = has_finite_coordinates(state.normalization_translation) &&
                std::all_of(state.cells.begin(), state.cells.end(), is_cell) &&
                std::all_of(state.points.begin(), state.points.end(),
                            has_finite_coordinates<std::array<double, d>>) &&
                (state.points.empty() || extent_of<d>(state.points).is_measurable());
  for (std::size_t v = 0; result && v < state.vertex_cells.size(); ++v)
    result = is_cell_of(v);
  return result;
}

} // namespace internal

/// \relates State
/// Returns whether all numbers of `a` and `b` are equal.
template <int d> bool operator==(const State<d>& a, const State<d>& b) {
  return internal::members(a) == internal::members(b);
}

/// \relates State
/// Returns whether some number of `a` and `b` differs.
template <int d> bool operator!=(const State<d>& a, const State<d>& b) { return !(a == b); }

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_STATE_H
