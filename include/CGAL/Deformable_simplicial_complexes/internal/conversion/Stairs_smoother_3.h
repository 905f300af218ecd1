// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_CONVERSION_STAIRS_SMOOTHER_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_CONVERSION_STAIRS_SMOOTHER_3_H

#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>

#include <CGAL/Origin.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A smoother for the surface of voxels that keeps vertices near their initial positions
// ("constrained elastic surface nets", Gibson 1998). A vertex moves towards the mean of its
// neighbors. A vertex on a line where more than two facets meet moves towards the mean of its
// neighbors on such lines.
template <class Complex> class Stairs_smoother_3
{
public:
  using Point = typename Complex::Approximate_point;
  using Vector = typename Complex::Approximate_vector;

  // The displacement of a vertex from its initial position is bounded, along each axis, by half its
  // shortest edge. Vertices stay on the sides of the domain that they lie on.
  Stairs_smoother_3(const Interface_snapshot<Complex>& interface_, std::vector<Point> places,
                    const std::array<double, 3>& voxel)
      : m_places(std::move(places)), m_voxel(voxel),
        m_reach(m_places.size(), std::numeric_limits<double>::infinity()) {
    for (const auto& v : interface_.vertices)
      m_sides.push_back(v->boundary_class());
    std::vector<Edge> edges; // an edge appears once for each of its facets
    for (const auto& facet : interface_.facets())
      for (int i = 0; i < 3; ++i)
        edges.push_back(std::minmax(facet.vertices[i], facet.vertices[(i + 1) % 3]));
    std::sort(edges.begin(), edges.end());
    static constexpr std::ptrdiff_t facets_in_a_sheet = 2;
    std::vector<Edge> all, lines;
    for (auto first = edges.begin(); first != edges.end();) {
      const auto last = std::upper_bound(first, edges.end(), *first);
      all.push_back(*first);
      if (last - first > facets_in_a_sheet)
        lines.push_back(*first);
      first = last;
    }
    std::vector<std::size_t> lines_at(m_places.size(), 0);
    for (const auto& [a, b] : lines) {
      ++lines_at[a];
      ++lines_at[b];
    }
    const auto is_on_line = [&](std::size_t v) { return lines_at[v] >= 2; };
    for (const auto& [a, b] : all) {
      const double half = .5 * length(a, b);
      m_reach[a] = (std::min)(m_reach[a], half);
      m_reach[b] = (std::min)(m_reach[b], half);
    }
    for (const auto& [a, b] : all)
      if (!is_on_line(a) || !is_on_line(b)) {
        if (!is_on_line(a))
          m_ties.push_back({a, b});
        if (!is_on_line(b))
          m_ties.push_back({b, a});
      }
    for (const auto& [a, b] : lines) {
      if (is_on_line(a))
        m_ties.push_back({a, b});
      if (is_on_line(b))
        m_ties.push_back({b, a});
    }
  }

  // Moves all vertices by one step.
  void relax(std::vector<Point>& positions) const {
    // Fraction of the displacement to the mean. With this value a single voxel keeps enough volume
    // for one correction to restore it.
    static constexpr double part = .25;
    std::vector<Vector> sums(positions.size(), NULL_VECTOR);
    std::vector<std::size_t> numbers(positions.size(), 0);
    for (const auto& [v, neighbor] : m_ties) {
      sums[v] = sums[v] + (positions[neighbor] - positions[v]);
      ++numbers[v];
    }
    for (std::size_t v = 0; v < positions.size(); ++v) {
      Progress_scope::check();
      if (numbers[v] == 0)
        continue;
      const Vector displacement =
          positions[v] + sums[v] * (part / double(numbers[v])) - m_places[v];
      std::array<double, 3> kept;
      for (int axis = 0; axis < 3; ++axis)
        kept[axis] = Boundary_class::fixes(m_sides[v], axis)
                         ? 0
                         : std::clamp(displacement[axis], -m_reach[v] * m_voxel[axis],
                                      m_reach[v] * m_voxel[axis]);
      positions[v] = m_places[v] + Vector(kept[0], kept[1], kept[2]);
    }
  }

private:
  using Edge = std::pair<std::size_t, std::size_t>;

  // Returns the largest extent of an edge along an axis, in side lengths of a voxel.
  double length(std::size_t a, std::size_t b) const {
    double result = 0;
    for (int axis = 0; axis < 3; ++axis)
      result = (std::max)(result, std::abs(m_places[a][axis] - m_places[b][axis]) / m_voxel[axis]);
    return result;
  }

  std::vector<Point> m_places;
  std::array<double, 3> m_voxel;             // side lengths
  std::vector<double> m_reach;               // of vertices, in side lengths of a voxel
  std::vector<Boundary_class::Bits> m_sides; // of vertices
  std::vector<Edge> m_ties; // pairs of a vertex and a neighbor that it moves towards
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_CONVERSION_STAIRS_SMOOTHER_3_H
