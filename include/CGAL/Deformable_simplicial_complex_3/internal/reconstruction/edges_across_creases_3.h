// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_RECONSTRUCTION_EDGES_ACROSS_CREASES_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_RECONSTRUCTION_EDGES_ACROSS_CREASES_3_H

#include <CGAL/Deformable_simplicial_complex_3/internal/reconstruction/Crease_planes_3.h>
#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/For_each_index.h>

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// The edges of a surface that cut across a crease: their middles are beside it. The edges have no
// facets in common, as one new vertex may be all that a facet needs. Farthest from the crease
// first; shorter edges than that are left alone.
template <class Facets>
std::vector<std::array<std::size_t, 2>>
edges_across_creases(const Crease_planes_3& planes, const Facets& facets,
                     const std::vector<Crease_planes_3::Point>& positions, double shortest,
                     const For_each_index& for_each) {
  std::map<std::array<std::size_t, 2>, std::vector<std::size_t>> facets_of_edges;
  for (std::size_t f = 0; f < facets.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t v = facets[f].vertices[k], w = facets[f].vertices[(k + 1) % 3];
      facets_of_edges[{{(std::min)(v, w), (std::max)(v, w)}}].push_back(f);
    }
  std::vector<std::array<std::size_t, 2>> edges;
  for (const auto& [edge, around] : facets_of_edges)
    if ((positions[edge[0]] - positions[edge[1]]).squared_length() >= shortest * shortest)
      edges.push_back(edge);
  std::vector<double> squares(edges.size()); // of distances to creases
  for_each(edges.size(), [&](std::size_t e) {
    Progress_scope::check();
    squares[e] = planes.to_crease(CGAL::midpoint(positions[edges[e][0]], positions[edges[e][1]]))
                     .squared_length();
  });
  std::vector<std::size_t> order;
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (squares[e] > 0)
      order.push_back(e);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return squares[a] > squares[b]; });
  std::vector<char> is_taken(facets.size(), 0);
  std::vector<std::array<std::size_t, 2>> result;
  for (std::size_t e : order) {
    const std::vector<std::size_t>& around = facets_of_edges[edges[e]];
    if (std::any_of(around.begin(), around.end(), [&](std::size_t f) { return is_taken[f] != 0; }))
      continue;
    for (std::size_t f : around)
      is_taken[f] = 1;
    result.push_back(edges[e]);
  }
  return result;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_RECONSTRUCTION_EDGES_ACROSS_CREASES_3_H
