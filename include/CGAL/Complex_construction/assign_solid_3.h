// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_ASSIGN_SOLID_3_H
#define CGAL_COMPLEX_CONSTRUCTION_ASSIGN_SOLID_3_H

#include <CGAL/Complex_construction/internal/building/Solid_tetrahedra_3.h>
#include <CGAL/Deformable_simplicial_complexes/State.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/assemble_triangulation.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/hilbert_order.h>
#include <CGAL/Deformable_simplicial_complexes/internal/parts/assign_part.h>
#include <CGAL/Mesh_support/coordinates.h>
#include <CGAL/Mesh_support/internal/numbers/Extent.h>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// Sets the boundary classes of a state of finite cells: the sides of the box if they fill a box;
// otherwise, the boundary is fixed. The cells refer to vertex `i` by `i + 1`.
inline void classify_boundary(State<3>& state) {
  std::vector<std::array<std::size_t, 4>> cells(state.cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (std::size_t i = 0; i < 4; ++i)
      cells[c][i] = state.cells[c][i] - 1;
  const auto facets = boundary_facets(cells);
  Extent<3> box;
  for (const auto& facet : facets)
    for (const std::size_t v : facet.vertices)
      box.add(state.points[v]);
  const auto sides = [&](std::size_t v) { return box.sides(state.points[v]); };
  const bool is_box = std::all_of(facets.begin(), facets.end(), [&](const auto& f) {
    return (sides(f.vertices[0]) & sides(f.vertices[1]) & sides(f.vertices[2])) != 0;
  });
  state.boundary_classes.assign(state.points.size(), Boundary_class::inside);
  for (const auto& facet : facets)
    for (const std::size_t v : facet.vertices)
      state.boundary_classes[v] = is_box ? sides(v) : Boundary_class::fixed;
}

// Returns a state without its infinite cells.
inline State<3> finite_state(State<3> state) {
  std::size_t n = 0;
  for (std::size_t c = 0; c < state.cells.size(); ++c)
    if (std::find(state.cells[c].begin(), state.cells[c].end(), 0u) == state.cells[c].end()) {
      state.cells[n] = state.cells[c];
      state.cell_labels[n] = state.cell_labels[c];
      state.noted_qualities[n] = state.noted_qualities[c];
      state.failures[n] = state.failures[c];
      ++n;
    }
  state.cells.resize(n);
  state.cell_labels.resize(n);
  state.noted_qualities.resize(n);
  state.failures.resize(n);
  return state;
}

// Returns positions of a domain that is large enough to compute volumes and qualities. Throws
// `Invalid_cells_error` if it is not, or if a point has no cell.
template <class Complex>
std::vector<typename Complex::Point>
positions_of_solid(const std::vector<typename Complex::Point_3>& points,
                   const std::vector<std::array<std::size_t, 4>>& tetrahedra) {
  std::vector<typename Complex::Point> result;
  for (const auto& p : points)
    result.push_back(point_at<Complex>(coordinates(p)));
  if (!extent_of<3>(result).is_measurable())
    throw Invalid_cells_error("the extent of the domain is not between 1e-30 and 1e30; scale "
                              "the points, so that volumes and qualities can be computed");
  std::vector<bool> is_used(points.size(), false);
  for (const auto& tetrahedron : tetrahedra)
    for (const std::size_t v : tetrahedron)
      is_used[v] = true;
  const auto unused = std::find(is_used.begin(), is_used.end(), false);
  if (unused != is_used.end())
    throw Invalid_cells_error("a point belongs to no cell; remove it", {},
                              {std::size_t(unused - is_used.begin())});
  return result;
}

// Returns the state of labeled tetrahedra, along Hilbert curves.
// \param rank receives the index of the vertex of each position in the state
template <class Complex>
State<3> state_of_solid(const std::vector<typename Complex::Point>& positions,
                        const std::vector<std::array<std::size_t, 4>>& tetrahedra,
                        const std::vector<typename Complex::Label>& labels,
                        std::vector<std::size_t>& rank) {
  using Space = typename Complex::Space;
  std::vector<typename Complex::Point> barycenters;
  for (const auto& tetrahedron : tetrahedra) {
    typename Complex::Vector sum(CGAL::NULL_VECTOR);
    for (const std::size_t v : tetrahedron)
      sum = sum + (positions[v] - CGAL::ORIGIN);
    barycenters.push_back(CGAL::ORIGIN + sum / 4);
  }
  State<3> state;
  rank.resize(positions.size());
  for (const std::size_t v : hilbert_order<Space>(positions)) {
    rank[v] = state.points.size();
    state.points.push_back(coordinates_of<3>(positions[v]));
  }
  state.spacings.assign(positions.size(), 0);
  for (const std::size_t t : hilbert_order<Space>(barycenters)) {
    auto& cell = state.cells.emplace_back();
    for (std::size_t i = 0; i < 4; ++i)
      cell[i] = std::uint32_t(rank[tetrahedra[t][i]] + 1);
    state.cell_labels.push_back(labels[t]);
  }
  state.noted_qualities.assign(tetrahedra.size(), 0);
  state.failures.assign(tetrahedra.size(), 0);
  classify_boundary(state);
  return state;
}

} // namespace internal

/*!
\ingroup PkgComplexConstructionRef

Replaces a complex by given tetrahedra, whose union is the domain. The domain can have any shape,
see `Solid_domain`. n log n in the number of tetrahedra.

\tparam Complex an instance of `Deformable_simplicial_complex_3` with the domain `Solid_domain`

\param dsc the complex, which is unchanged if the function throws
\param points the vertices; each is in a tetrahedron
\param tetrahedra indices into `points`, oriented in any way
\param labels one label for each tetrahedron
\return the vertices of the points. A vertex at which the domain touches itself is the first one of
        its copies.

\throws Invalid_cells_error if there are no tetrahedra, coordinates are not finite, sizes or indices
        do not fit, a point is in no tetrahedron, or tetrahedra are degenerate or overlap
*/
template <class Complex>
std::vector<typename Complex::Vertex_handle>
assign_solid_3(Complex& dsc, const std::vector<typename Complex::Point_3>& points,
               std::vector<std::array<std::size_t, 4>> tetrahedra,
               const std::vector<typename Complex::Label>& labels) {
  if (labels.size() != tetrahedra.size())
    throw Invalid_cells_error("the number of labels differs from the number of tetrahedra: give "
                              "one label for each tetrahedron");
  internal::Solid_tetrahedra_3(points, tetrahedra, dsc.geom_traits()).boundary(); // checks
  internal::orient_tetrahedra(points, tetrahedra, dsc.geom_traits());
  auto positions = internal::positions_of_solid<Complex>(points, tetrahedra);
  const auto originals = internal::separate_touching_cells(points.size(), tetrahedra);
  for (std::size_t i = points.size(); i < originals.size(); ++i)
    positions.push_back(positions[originals[i]]);
  std::vector<std::size_t> rank;
  const auto vertices = internal::assign_part(
      dsc, internal::state_of_solid<Complex>(positions, tetrahedra, labels, rank));
  dsc.measure_interface_edges();
  std::vector<typename Complex::Vertex_handle> result;
  for (std::size_t i = 0; i < points.size(); ++i)
    result.push_back(vertices[rank[i]]);
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_COMPLEX_CONSTRUCTION_ASSIGN_SOLID_3_H
