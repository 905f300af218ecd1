// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_SMALL_HANDLES_3_H
#define CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_SMALL_HANDLES_3_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/internal/sets/Disjoint_sets.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/Sampled_surface_3.h>

#include <set>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The handles of a closed manifold surface that lie in small balls about its vertices. A patch of
// the surface in such a ball has a handle if its genus is positive.
class Small_handles_3
{
public:
  using Point = Cloud_kernel::Point_3;

  template <class Facets>
  Small_handles_3(const Facets& facets, const std::vector<Point>& positions)
      : m_positions(positions), m_places(facets.size(), nowhere) {
    for (const auto& f : facets)
      m_facets.push_back({f.vertices[0], f.vertices[1], f.vertices[2]});
    find_neighbors();
  }

  // Returns one vertex of each handle. `radii` are the radii of the balls about the vertices.
  std::vector<std::size_t> find(const std::vector<double>& radii) {
    std::vector<std::size_t> first_facets(m_positions.size(), nowhere);
    for (std::size_t f = m_facets.size(); f-- > 0;)
      for (std::size_t v : m_facets[f])
        first_facets[v] = f;
    std::vector<char> has_handle(m_positions.size(), 0);
    for (std::size_t v = 0; v < m_positions.size(); ++v) {
      Progress_scope::check();
      if (first_facets[v] == nowhere)
        continue;
      collect_patch(v, first_facets[v], radii[v]);
      has_handle[v] = genus_of_patch() > 0;
    }
    // Neighboring vertices belong to the same handle.
    Disjoint_sets handles(m_positions.size());
    for (const auto& f : m_facets)
      for (std::size_t k = 0; k < 3; ++k)
        if (has_handle[f[k]] != 0 && has_handle[f[(k + 1) % 3]] != 0)
          handles.join(f[k], f[(k + 1) % 3]);
    std::vector<std::size_t> result;
    for (std::size_t v = 0; v < m_positions.size(); ++v)
      if (has_handle[v] != 0 && handles.find(v) == v)
        result.push_back(v);
    return result;
  }

private:
  static constexpr std::size_t nowhere = (std::numeric_limits<std::size_t>::max)();

  // Finds the opposite corner of each corner. Corner k of facet f has the index 3 f + k. Two
  // corners are opposite if they face the same edge.
  void find_neighbors() {
    std::vector<std::pair<std::array<std::size_t, 2>, std::size_t>> edges; // and opposite corners
    for (std::size_t c = 0; c < 3 * m_facets.size(); ++c) {
      const std::size_t v = vertex(next(c)), w = vertex(next(next(c)));
      edges.push_back({{{(std::min)(v, w), (std::max)(v, w)}}, c});
    }
    std::sort(edges.begin(), edges.end());
    m_opposite.resize(edges.size());
    for (std::size_t e = 0; e + 1 < edges.size(); e += 2) {
      m_opposite[edges[e].second] = edges[e + 1].second;
      m_opposite[edges[e + 1].second] = edges[e].second;
    }
  }

  static std::size_t next(std::size_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
  std::size_t vertex(std::size_t corner) const { return m_facets[corner / 3][corner % 3]; }

  bool is_within(std::size_t f, const Point& center, double radius) const {
    return std::all_of(m_facets[f].begin(), m_facets[f].end(), [&](std::size_t v) {
      return (m_positions[v] - center).squared_length() <= radius * radius;
    });
  }

  // Collects the facets in a ball about a vertex that are connected to the vertex across edges.
  // Facets at the vertex are tried in turn, because some of them may not lie in the ball.
  void collect_patch(std::size_t v, std::size_t first, double radius) {
    for (std::size_t f : m_patch)
      m_places[f] = nowhere;
    m_patch.clear();
    std::size_t f = first;
    do {
      if (is_within(f, m_positions[v], radius)) {
        add(f);
        break;
      }
      const std::size_t k =
          std::size_t(std::find(m_facets[f].begin(), m_facets[f].end(), v) - m_facets[f].begin());
      f = m_opposite[next(3 * f + k)] / 3;
    } while (f != first);
    for (std::size_t i = 0; i < m_patch.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t g = m_opposite[3 * m_patch[i] + k] / 3;
        if (m_places[g] == nowhere && is_within(g, m_positions[v], radius))
          add(g);
      }
  }
  void add(std::size_t f) {
    m_places[f] = m_patch.size();
    m_patch.push_back(f);
  }

  // Returns the genus of the patch by Euler's formula. A vertex counts once for each fan of facets
  // at it.
  int genus_of_patch() const {
    Disjoint_sets fans(3 * m_patch.size()); // of corners
    std::vector<std::size_t> border;        // corners opposite to boundary edges
    std::size_t edges = 0;
    for (std::size_t c = 0; c < 3 * m_patch.size(); ++c) {
      const std::size_t other = m_opposite[3 * m_patch[c / 3] + c % 3], g = m_places[other / 3];
      if (g == nowhere) {
        border.push_back(c);
        ++edges;
        continue;
      }
      const std::size_t d = 3 * g + other % 3; // both facets have the same orientation
      if (c < d)
        ++edges;
      fans.join(next(c), next(next(d)));
      fans.join(next(next(c)), next(d));
    }
    std::size_t vertices = 0;
    for (std::size_t c = 0; c < 3 * m_patch.size(); ++c)
      vertices += fans.find(c) == c;
    Disjoint_sets loops = fans;
    for (std::size_t c : border)
      loops.join(next(c), next(next(c)));
    std::set<std::size_t> holes;
    for (std::size_t c : border)
      holes.insert(loops.find(next(c)));
    return m_patch.empty()
               ? 0
               : (2 - int(holes.size()) - int(vertices) + int(edges) - int(m_patch.size())) / 2;
  }

  const std::vector<Point>& m_positions;
  std::vector<std::array<std::size_t, 3>> m_facets;
  std::vector<std::size_t> m_opposite; // opposite corner of each corner
  std::vector<std::size_t> m_patch;    // facets of the patch
  std::vector<std::size_t> m_places;   // index of each facet in the patch
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_SMALL_HANDLES_3_H
