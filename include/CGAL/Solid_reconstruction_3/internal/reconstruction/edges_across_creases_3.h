// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Solid_reconstruction_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_EDGES_ACROSS_CREASES_3_H
#define CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_EDGES_ACROSS_CREASES_3_H

#include <CGAL/Deformable_simplicial_complexes/For_each_index.h>
#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>
#include <CGAL/Solid_reconstruction_3/internal/reconstruction/Crease_planes_3.h>

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// An edge to split, and the destination of the new vertex.
struct Crease_split_3
{
  std::array<std::size_t, 2> edge;
  Crease_planes_3::Point destination;
  double squared_distance; // from the surface to the destination
};

// Returns the edges of a surface that cut across a crease: edges whose midpoint is near a crease
// but not on it, and the longest edge of each facet whose centroid is. A facet may cut off a corner
// although all its edges touch the corner. No facet has two of the edges, because one new vertex
// may be enough. The edges are sorted by decreasing distance from the crease. Edges shorter than
// `shortest` are omitted.
template <class Facets>
std::vector<Crease_split_3>
edges_across_creases(const Crease_planes_3& planes, const Facets& facets,
                     const std::vector<Crease_planes_3::Point>& positions, double shortest,
                     const For_each_index& for_each) {
  using Edge = std::array<std::size_t, 2>;
  const auto squared_length = [&](const Edge& e) {
    return (positions[e[0]] - positions[e[1]]).squared_length();
  };
  std::map<Edge, std::vector<std::size_t>> facets_of_edges;
  std::vector<Crease_split_3> candidates; // destinations are on the surface at first
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const auto& v = facets[f].vertices;
    Edge longest = {{v[0], v[1]}};
    for (std::size_t k = 0; k < 3; ++k) {
      const Edge e = {{(std::min)(v[k], v[(k + 1) % 3]), (std::max)(v[k], v[(k + 1) % 3])}};
      facets_of_edges[e].push_back(f);
      if (squared_length(e) >= squared_length(longest))
        longest = e;
    }
    candidates.push_back(
        {longest, CGAL::centroid(positions[v[0]], positions[v[1]], positions[v[2]]), 0});
  }
  for (const auto& [e, around] : facets_of_edges)
    candidates.push_back({e, CGAL::midpoint(positions[e[0]], positions[e[1]]), 0});
  for_each(candidates.size(), [&](std::size_t i) {
    Progress_scope::check();
    Crease_split_3& c = candidates[i];
    if (squared_length(c.edge) < shortest * shortest)
      return;
    const auto displacement = planes.to_crease(c.destination);
    c.destination = c.destination + displacement;
    c.squared_distance = displacement.squared_length();
  });
  std::stable_sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
    return a.squared_distance > b.squared_distance;
  });
  std::vector<char> is_taken(facets.size(), 0);
  std::vector<Crease_split_3> result;
  for (const Crease_split_3& c : candidates) {
    const std::vector<std::size_t>& around = facets_of_edges[c.edge];
    if (!(c.squared_distance > 0) ||
        std::any_of(around.begin(), around.end(), [&](std::size_t f) { return is_taken[f] != 0; }))
      continue;
    for (std::size_t f : around)
      is_taken[f] = 1;
    result.push_back(c);
  }
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_EDGES_ACROSS_CREASES_3_H
