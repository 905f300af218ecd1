// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_STATE_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_STATE_H

#include <CGAL/Deformable_simplicial_complexes/coordinates.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/Extent.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

is everything a deformable simplicial complex consists of, as plain numbers: a complex that is
restored from its state continues to the same bits as the original would have. That takes more than
points and cells: the order of the simplices is the order in which they are visited, the cell
stored with a vertex is where the walk around it begins, and the order of the vertices in a cell is
the order in which its terms are summed.

States are obtained by `Deformable_simplicial_complex_3::state()`, put back by
`Deformable_simplicial_complex_3::restore()`, and kept in files by `IO::write_checkpoint()`.
Coordinates and lengths are those of the complex, not of the user, see
`Deformable_simplicial_complex_3::Normalization`.

\tparam d the dimension
*/
template <int d> struct State
{
  /// the coordinates of the finite vertices, by increasing time stamp
  std::vector<std::array<double, d>> points;

  /// the boundary classes of the finite vertices
  std::vector<std::uint8_t> boundary_classes;

  /// for each of the finite vertices its `spacing()`
  std::vector<float> spacings;

  /// for each vertex the index in `cells` of the cell stored with it: first that of the infinite
  /// vertex, if there is one, then that of each finite one
  std::vector<std::uint32_t> vertex_cells;

  /// the vertices of all cells, infinite ones included, by increasing time stamp of the cell: zero
  /// is the infinite vertex, `i + 1` the vertex `i`
  std::vector<std::array<std::uint32_t, d + 1>> cells;

  /// the labels of `cells`
  std::vector<std::int32_t> cell_labels;

  /// for each of `cells` the quality when its shape last changed essentially
  std::vector<float> noted_qualities;

  /// for each of `cells` what was tried in vain since then, as bits
  std::vector<std::uint8_t> failures;

  /// for each of `cells` the number of its component, as events name it; 0 for infinite cells
  std::vector<std::uint32_t> cell_components;

  /// the mean length of the interface edges when the complex was built
  double mean_interface_edge = 0;

  /// the smallest length of an interface edge when the complex was built
  double minimum_interface_edge = 0;

  /// the translation of the normalization
  std::array<double, d> normalization_translation = {};

  /// the scale of the normalization
  double normalization_scale = 1;

  /// the periods of the domain if that is a torus, where nothing is infinite, else 0
  std::array<double, d> periods = {};
};

namespace internal {

// References to all members: the one list that comparison and files are made of. It does not
// compile with a member too few.
template <class State_d> auto members(State_d& state) {
  auto& [points, boundary_classes, spacings, vertex_cells, cells, cell_labels, noted_qualities,
         failures, cell_components, mean_interface_edge, minimum_interface_edge,
         normalization_translation, normalization_scale, periods] = state;
  return std::tie(points, boundary_classes, spacings, vertex_cells, cells, cell_labels,
                  noted_qualities, failures, cell_components, mean_interface_edge,
                  minimum_interface_edge, normalization_translation, normalization_scale, periods);
}

// Whether the arrays that run parallel have the same size.
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

// Whether the arrays fit together, all coordinates are finite, and no cell has a vertex twice.
template <int d> bool is_consistent(const State<d>& state) {
  const auto is_length = [](double length) { return length >= 0 && std::isfinite(length); };
  if (!has_consistent_sizes(state) || state.cells.size() >= std::uint32_t(-1) ||
      !(state.normalization_scale > 0) || !std::isfinite(state.normalization_scale) ||
      !is_length(state.mean_interface_edge) || !is_length(state.minimum_interface_edge) ||
      !std::all_of(state.spacings.begin(), state.spacings.end(), is_length))
    return false;
  // Where nothing is infinite, no cell has the vertex 0.
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
/// returns whether all numbers of `a` and `b` are equal.
template <int d> bool operator==(const State<d>& a, const State<d>& b) {
  return internal::members(a) == internal::members(b);
}

/// \relates State
/// returns whether some number of `a` and `b` differs.
template <int d> bool operator!=(const State<d>& a, const State<d>& b) { return !(a == b); }

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_STATE_H
