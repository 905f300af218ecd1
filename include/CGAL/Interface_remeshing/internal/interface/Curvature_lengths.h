// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_INTERNAL_INTERFACE_CURVATURE_LENGTHS_H
#define CGAL_INTERFACE_REMESHING_INTERNAL_INTERFACE_CURVATURE_LENGTHS_H

#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/internal/interface/Interface_fan.h>
#include <CGAL/Interface_remeshing/interface_triangles_3.h>
#include <CGAL/Interface_remeshing/vertices_on_junctions.h>

#include <CGAL/number_utils.h>

#include <functional>
#include <limits>
#include <queue>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The bending of the interface of a snapshot at its vertices.
template <class Complex> struct Interface_bends
{
  using Points = std::vector<typename Complex::Point>;
  using Vector = typename Complex::Vector;

  // Returns the unit normals, out of the larger label; 0 where the facet normals cancel each other.
  // In the plane, it is the normal of the circle through a vertex and its two neighbors.
  static std::vector<Vector> normals(const Interface_snapshot<Complex>& interface_,
                                     const Points& positions) {
    if constexpr (Complex::dimension == 3) {
      return vertex_normals(interface_, positions);
    } else {
      std::vector<Vector> result(positions.size(), Vector(0, 0));
      for_each_side(interface_, positions, [&](std::size_t v, const Vector& edge) {
        // The normal of the circle is the sum of the edge normals, each divided by its edge length.
        result[v] = result[v] + Vector(edge.y(), -edge.x()) / edge.squared_length();
      });
      static constexpr double rounding = 1e-9; // relative to the sum of weights
      std::vector<double> weights(positions.size(), 0);
      for_each_side(interface_, positions, [&](std::size_t v, const Vector& edge) {
        weights[v] += 1 / std::sqrt(edge.squared_length());
      });
      for (std::size_t v = 0; v < result.size(); ++v) {
        const double length = std::sqrt(result[v].squared_length());
        result[v] = length > rounding * weights[v] ? result[v] / length : Vector(0, 0);
      }
      return result;
    }
  }

  // Returns for each vertex whether the normals of two incident facets differ by more than `angle`,
  // in radians.
  static std::vector<char> on_features(const Interface_snapshot<Complex>& interface_,
                                       const Points& positions, double angle) {
    if constexpr (Complex::dimension == 3) {
      return vertices_on_features(interface_, positions, angle);
    } else {
      std::vector<char> result(positions.size(), false);
      std::vector<Vector> first(positions.size(), Vector(0, 0));
      for_each_side(interface_, positions, [&](std::size_t v, const Vector& edge) {
        if (first[v] == Vector(0, 0))
          first[v] = edge;
        else
          result[v] = result[v] || turn_between(first[v], edge) > angle;
      });
      return result;
    }
  }

private:
  // Calls a function for each vertex with each incident edge, directed so that the larger label is
  // on the left.
  template <class Function>
  static void for_each_side(const Interface_snapshot<Complex>& interface_, const Points& positions,
                            const Function& function) {
    for (const auto& segment : interface_.facets()) {
      const auto& p = positions[segment.vertices[0]];
      const Vector edge = interface_.domain.nearest_image(p, positions[segment.vertices[1]]) - p;
      if (edge.squared_length() > 0)
        for (std::size_t v : segment.vertices)
          function(v, edge);
    }
  }
};

// Calls a function with the ends of each edge of the facets. In space, each edge is visited twice.
template <class Facets, class Function>
void for_each_edge_of(const Facets& facets, const Function& function) {
  for (const auto& facet : facets)
    for (std::size_t i = 0; i < facet.vertices.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        function(facet.vertices[i], facet.vertices[j]);
}

// The normals of an interface. Vertices on sharp edges, and vertices where more than two labels
// meet, have none.
template <class Complex> struct Smooth_normals
{
  using Points = std::vector<typename Complex::Point>;

  std::vector<typename Complex::Vector> normals;
  std::vector<char> is_smooth; // whether a vertex has a normal

  // The feature angle is in degrees.
  Smooth_normals(const Interface_snapshot<Complex>& interface_, const Points& positions,
                 double feature_angle)
      : normals(Interface_bends<Complex>::normals(interface_, positions)) {
    const std::vector<char> is_on_junction = vertices_on_junctions(interface_);
    const auto is_on_feature = Interface_bends<Complex>::on_features(
        interface_, positions, feature_angle * (CGAL_PI / 180));
    for (std::size_t v = 0; v < normals.size(); ++v)
      is_smooth.push_back(!is_on_junction[v] && !is_on_feature[v]);
  }
};

/*
Target edge lengths at the vertices of an interface, from its curvature. The distance of an edge of
length h from the smooth surface is about curvature * h^2 / 8; the target edge length is the one for
which this distance equals the tolerance. Vertices without a normal have no curvature.
*/
template <class Complex> class Curvature_lengths
{
public:
  using Snapshot = Interface_snapshot<Complex>;
  using Points = std::vector<typename Complex::Point>;

  Curvature_lengths(const Snapshot& interface_, const Points& positions,
                    const Smooth_normals<Complex>& normals, double tolerance, double shortest)
      : m_lengths(positions.size(), std::numeric_limits<double>::infinity()) {
    m_first.assign(positions.size() + 1, 0);
    for_each_edge_of(interface_.facets(), [&](std::size_t a, std::size_t b) {
      ++m_first[a];
      ++m_first[b];
      if (!normals.is_smooth[a] || !normals.is_smooth[b])
        return;
      const auto edge = interface_.domain.nearest_image(positions[a], positions[b]) - positions[a];
      const double bend =
          std::abs((normals.normals[b] - normals.normals[a]) * edge); // curvature * squared length
      if (!(bend > 0))
        return;
      const double length =
          (std::max)(shortest, std::sqrt(8 * tolerance * edge.squared_length() / bend));
      m_lengths[a] = (std::min)(m_lengths[a], length);
      m_lengths[b] = (std::min)(m_lengths[b], length);
    });
    for (std::size_t v = 0, sum = 0; v < m_first.size(); ++v)
      sum = m_first[v] += sum;
    m_neighbors.resize(m_first.back());
    for_each_edge_of(interface_.facets(), [&](std::size_t a, std::size_t b) {
      const double distance =
          std::sqrt((interface_.domain.nearest_image(positions[a], positions[b]) - positions[a])
                        .squared_length());
      m_neighbors[--m_first[a]] = {b, distance};
      m_neighbors[--m_first[b]] = {a, distance};
    });
  }

  // Returns the target edge lengths, at most `longest`, with a bounded gradation: the lengths at
  // the ends of an edge differ by at most `gradation` times the length of the edge.
  std::vector<double> graded(double longest, double gradation) const {
    std::vector<double> lengths = m_lengths;
    for (double& length : lengths)
      length = (std::min)(length, longest);
    grade(lengths, gradation);
    return lengths;
  }

  // Reduces lengths at the vertices until their gradation is bounded. The vertices are visited by
  // increasing length, as in Dijkstra's algorithm.
  void grade(std::vector<double>& lengths, double gradation) const {
    using Entry = std::pair<double, std::size_t>; // the length at a vertex, and the vertex
    std::vector<Entry> entries;
    for (std::size_t v = 0; v < lengths.size(); ++v)
      entries.emplace_back(lengths[v], v);
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue(std::greater<>(),
                                                                         std::move(entries));
    while (!queue.empty()) {
      const auto [length, a] = queue.top();
      queue.pop();
      if (length > lengths[a])
        continue; // outdated: the length was reduced later
      for (std::size_t k = m_first[a]; k < m_first[a + 1]; ++k) {
        const auto& [b, distance] = m_neighbors[k];
        const double bound = length + gradation * distance;
        if (lengths[b] > bound) {
          lengths[b] = bound;
          queue.emplace(bound, b);
        }
      }
    }
  }

private:
  struct Neighbor
  {
    std::size_t vertex;
    double distance;
  };

  std::vector<double> m_lengths;    // target edge lengths, without an upper bound
  std::vector<std::size_t> m_first; // first neighbor of each vertex, and their number
  std::vector<Neighbor> m_neighbors;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INTERFACE_REMESHING_INTERNAL_INTERFACE_CURVATURE_LENGTHS_H
