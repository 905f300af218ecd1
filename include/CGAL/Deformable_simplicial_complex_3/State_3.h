// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_STATE_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_STATE_3_H

#include <CGAL/Deformable_simplicial_complex_3/internal/has_finite_coordinates.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

is everything a deformable simplicial complex consists of, as plain numbers: a complex that is
restored from its state continues to the same bits as the original would have. That takes more than
points and tetrahedra: the order of the simplices is the order in which they are visited, the cell
stored with a vertex is where the walk around it begins, and the order of the vertices in a cell is
the order in which its terms are summed.

States are obtained by `Deformable_simplicial_complex_3::state()`, put back by
`Deformable_simplicial_complex_3::restore()`, and kept in files by `IO::write_checkpoint()`.
Coordinates and lengths are those of the complex, not of the user, see
`Deformable_simplicial_complex_3::Normalization`.
*/
struct Deformable_simplicial_complex_state_3
{
  /// the coordinates of the finite vertices, by increasing time stamp
  std::vector<std::array<double, 3>> points;

  /// the boundary classes of the finite vertices
  std::vector<std::uint8_t> boundary_classes;

  /// for each vertex the index in `cells` of the cell stored with it: first that of the infinite
  /// vertex, then at `i + 1` that of the vertex `i`
  std::vector<std::uint32_t> vertex_cells;

  /// the vertices of all cells, infinite ones included, by increasing time stamp of the cell: zero
  /// is the infinite vertex, `i + 1` the vertex `i`
  std::vector<std::array<std::uint32_t, 4>> cells;

  /// the labels of `cells`
  std::vector<std::int32_t> cell_labels;

  /// for each of `cells` the quality at which improving it was last tried in vain
  std::vector<float> exhausted_qualities;

  /// the mean length of the interface edges when the complex was built
  double mean_interface_edge = 0;

  /// the smallest length of an interface edge when the complex was built
  double minimum_interface_edge = 0;

  /// the translation of the normalization
  std::array<double, 3> normalization_translation = {0, 0, 0};

  /// the scale of the normalization
  double normalization_scale = 1;
};

namespace Deformable_simplicial_complexes {
namespace internal {

// References to all members: the one list that comparison and files are made of.
template <class State> auto members(State& state) {
  return std::tie(state.points, state.boundary_classes, state.vertex_cells, state.cells,
                  state.cell_labels, state.exhausted_qualities, state.mean_interface_edge,
                  state.minimum_interface_edge, state.normalization_translation,
                  state.normalization_scale);
}

// Whether the arrays that run parallel have the same size.
inline bool has_consistent_sizes(const Deformable_simplicial_complex_state_3& state) {
  const std::size_t infinite = state.cells.empty() ? 0 : 1;
  return state.boundary_classes.size() == state.points.size() &&
         state.vertex_cells.size() == state.points.size() + infinite &&
         state.cell_labels.size() == state.cells.size() &&
         state.exhausted_qualities.size() == state.cells.size();
}

// Whether the arrays fit together, all coordinates are finite, and no cell has a vertex twice.
inline bool is_consistent(const Deformable_simplicial_complex_state_3& state) {
  if (!has_consistent_sizes(state) || state.cells.size() >= std::uint32_t(-1) ||
      !(state.normalization_scale > 0) || !std::isfinite(state.normalization_scale) ||
      !(state.mean_interface_edge >= 0) || !(state.minimum_interface_edge >= 0))
    return false;
  const auto is_cell = [&](std::array<std::uint32_t, 4> c) {
    std::sort(c.begin(), c.end());
    return c[3] <= state.points.size() && std::adjacent_find(c.begin(), c.end()) == c.end();
  };
  const auto is_cell_of = [&](std::size_t v) {
    const std::size_t c = state.vertex_cells[v];
    return c < state.cells.size() &&
           std::find(state.cells[c].begin(), state.cells[c].end(), v) != state.cells[c].end();
  };
  bool result = has_finite_coordinates(state.normalization_translation) &&
                std::all_of(state.cells.begin(), state.cells.end(), is_cell) &&
                std::all_of(state.points.begin(), state.points.end(),
                            has_finite_coordinates<std::array<double, 3>>) &&
                (state.points.empty() || has_measurable_extent(state.points));
  for (std::size_t v = 0; result && v < state.vertex_cells.size(); ++v)
    result = is_cell_of(v);
  return result;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes

/// \relates Deformable_simplicial_complex_state_3
/// returns whether all numbers of `a` and `b` are equal.
inline bool operator==(const Deformable_simplicial_complex_state_3& a,
                       const Deformable_simplicial_complex_state_3& b) {
  return Deformable_simplicial_complexes::internal::members(a) ==
         Deformable_simplicial_complexes::internal::members(b);
}

/// \relates Deformable_simplicial_complex_state_3
/// returns whether some number of `a` and `b` differs.
inline bool operator!=(const Deformable_simplicial_complex_state_3& a,
                       const Deformable_simplicial_complex_state_3& b) {
  return !(a == b);
}

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_STATE_3_H
