// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_REPAIR_SURFACE_COMPONENTS_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_REPAIR_SURFACE_COMPONENTS_3_H

#include <CGAL/Deformable_simplicial_complexes/internal/soups/Soup_regions_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/soups/Triangle_soup_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/soups/soup_intersections_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/soups/soup_rays_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <queue>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The connected components of a surface: triangles that are connected through edges with exactly
// two triangles. The closed components are oriented: outwards, or inwards if they are cavities. A
// component is a cavity if it is nested in an odd number of closed components that it does not
// intersect.
// \pre no triangle is degenerate
class Surface_components_3
{
public:
  explicit Surface_components_3(const Triangle_soup_3& input) : m_soup(merge_points(input)) {
    connect();
    find_closed_components();
    find_crossings();
    orient_closed_components();
  }

  // Returns the input with oriented triangles.
  const Triangle_soup_3& oriented_soup() const { return m_soup; }

  std::size_t of(std::size_t triangle) const { return m_components[triangle]; }

  // Returns whether a component bounds a solid: it can be oriented, and it has no boundary edges.
  bool is_closed(std::size_t component) const { return m_is_closed[component]; }

  std::size_t number_of_crossing_pairs() const { return m_crossing_pairs; } // pairs of triangles

  // Returns the number of components that intersect others or themselves.
  std::size_t number_of_crossing_components() const {
    std::set<std::size_t> components;
    for (const auto& pair : m_crossings)
      components.insert({pair.first, pair.second});
    return components.size();
  }

private:
  // Returns whether the side runs from its smaller to its larger vertex index in the orientation of
  // the triangle.
  bool runs_forward(const Triangle_side& side) const {
    const Triangle_indices& t = m_soup.triangles[side.triangle];
    const std::size_t i = std::find(t.begin(), t.end(), side.vertices[0]) - t.begin();
    return t[(i + 1) % 3] == side.vertices[1];
  }

  // Numbers the components, and orients neighbors consistently where possible.
  void connect() {
    m_sides = sorted_sides(m_soup.triangles);
    std::vector<std::vector<Neighbor>> neighbors(m_soup.triangles.size());
    for (auto side = m_sides.cbegin(); side != m_sides.cend();) {
      const auto end = end_of_edge(side, m_sides.cend());
      if (end - side == 2) {
        const bool agrees = runs_forward(side[0]) != runs_forward(side[1]);
        neighbors[side[0].triangle].push_back({side[1].triangle, agrees});
        neighbors[side[1].triangle].push_back({side[0].triangle, agrees});
      }
      side = end;
    }
    static constexpr std::size_t unknown = std::size_t(-1);
    m_components.assign(m_soup.triangles.size(), unknown);
    std::vector<char> is_turned(m_soup.triangles.size(), 0);
    for (std::size_t first = 0; first < m_components.size(); ++first) {
      if (m_components[first] != unknown)
        continue;
      std::queue<std::size_t> queue;
      m_components[first] = m_first_triangles.size();
      for (queue.push(first); !queue.empty(); queue.pop())
        for (const Neighbor& n : neighbors[queue.front()])
          if (m_components[n.triangle] == unknown) {
            m_components[n.triangle] = m_first_triangles.size();
            is_turned[n.triangle] = is_turned[queue.front()] != !n.agrees;
            queue.push(n.triangle);
          }
      m_first_triangles.push_back(first);
    }
    for (std::size_t t = 0; t < is_turned.size(); ++t)
      if (is_turned[t])
        turn(t);
  }

  void turn(std::size_t t) { std::swap(m_soup.triangles[t][1], m_soup.triangles[t][2]); }

  // Finds the closed components: in each edge, the triangles of the component cancel in
  // orientation.
  void find_closed_components() {
    m_is_closed.assign(m_first_triangles.size(), 1);
    for (auto side = m_sides.cbegin(); side != m_sides.cend();) {
      const auto end = end_of_edge(side, m_sides.cend());
      std::map<std::size_t, int> sums;
      for (; side != end; ++side)
        sums[m_components[side->triangle]] += runs_forward(*side) ? 1 : -1;
      for (const auto& [component, sum] : sums)
        if (sum != 0)
          m_is_closed[component] = 0;
    }
  }

  void find_crossings() {
    const auto pairs = crossing_triangles(m_soup);
    m_crossing_pairs = pairs.size();
    for (const auto& [s, t] : pairs)
      m_crossings.insert(std::minmax(m_components[s], m_components[t]));
  }

  void orient_closed_components() {
    const std::vector<int> depths = depths_of_components();
    std::vector<double> volumes(m_first_triangles.size(), 0); // six times the volume
    for (std::size_t t = 0; t < m_components.size(); ++t)
      volumes[m_components[t]] += cone(t);
    for (std::size_t t = 0; t < m_components.size(); ++t) {
      const std::size_t component = m_components[t];
      if (m_is_closed[component] && (volumes[component] < 0) != (depths[component] % 2 == 1))
        turn(t);
    }
  }

  // Returns six times the signed volume of the tetrahedron of a triangle and a point of its
  // component. Such a point reduces rounding errors.
  double cone(std::size_t t) const {
    const Coordinates_3& o = m_soup.points[m_soup.triangles[m_first_triangles[m_components[t]]][0]];
    std::array<Coordinates_3, 3> p;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        p[i][axis] = m_soup.points[m_soup.triangles[t][i]][axis] - o[axis];
    return p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) +
           p[0][1] * (p[1][2] * p[2][0] - p[1][0] * p[2][2]) +
           p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
  }

  // Returns, for each component, the number of closed components that contain it and that it does
  // not intersect.
  std::vector<int> depths_of_components() const {
    const std::vector<Soup_ray_3> rays = shoot_rays(m_soup, m_first_triangles);
    std::vector<int> depths(rays.size(), 0);
    for (std::size_t component = 0; component < rays.size(); ++component) {
      std::map<std::size_t, int> crossed; // number of crossings with each component
      for (const Ray_crossing_3& crossing : rays[component].crossings)
        ++crossed[m_components[crossing.triangle]];
      for (const auto& [other, times] : crossed)
        depths[component] += other != component && times % 2 == 1 && m_is_closed[other] &&
                             m_crossings.count(std::minmax(component, other)) == 0;
    }
    return depths;
  }

  struct Neighbor
  {
    std::size_t triangle;
    bool agrees; // whether the orientations agree
  };

  Triangle_soup_3 m_soup;
  std::vector<Triangle_side> m_sides;
  std::vector<std::size_t> m_components;      // component of each triangle
  std::vector<std::size_t> m_first_triangles; // first triangle of each component
  std::vector<char> m_is_closed;
  std::set<std::pair<std::size_t, std::size_t>> m_crossings; // pairs of components
  std::size_t m_crossing_pairs = 0;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_REPAIR_SURFACE_COMPONENTS_3_H
