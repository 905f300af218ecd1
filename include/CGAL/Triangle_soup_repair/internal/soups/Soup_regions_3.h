// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_SOUPS_SOUP_REGIONS_3_H
#define CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_SOUPS_SOUP_REGIONS_3_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/internal/sets/Disjoint_sets.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Triangle_soup_3.h>
#include <CGAL/Triangle_soup_repair/internal/soups/soup_intersections_3.h>
#include <CGAL/Triangle_soup_repair/internal/soups/soup_rays_3.h>

#include <optional>
#include <queue>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The regions into which triangles divide space. Takes time O(n log n).
// \pre triangles meet in common vertices and edges only, no two have the same corners, and none is
// degenerate
class Soup_regions_3
{
public:
  static constexpr std::size_t unbounded = 0; // number of the unbounded region

  explicit Soup_regions_3(const Triangle_soup_3& soup)
      : m_sets(2 * soup.triangles.size() + 1), m_regions(2 * soup.triangles.size()) {
    Disjoint_sets components(soup.triangles.size());
    join_at_edges(soup, components);
    join_components(soup, components);
    number_regions();
  }

  // Returns the number of regions, including the unbounded one.
  std::size_t size() const { return m_size; }

  // Return the region on each side of a triangle.
  std::size_t in_front_of(std::size_t triangle) const { return m_regions[2 * triangle]; }
  std::size_t behind(std::size_t triangle) const { return m_regions[2 * triangle + 1]; }

  // Returns the winding number of each region if triangle t is counted `multiplicities[t]` times:
  // the number increases by the multiplicity from the front to the back of the triangle. Returns
  // `nullopt` if the numbers are inconsistent.
  std::optional<std::vector<int>> winding_numbers(const std::vector<int>& multiplicities) const {
    std::vector<int> numbers(m_size, 0);
    visit_regions([&](std::size_t t, bool to_back) {
      const int change = to_back ? multiplicities[t] : -multiplicities[t];
      numbers[to_back ? behind(t) : in_front_of(t)] =
          numbers[to_back ? in_front_of(t) : behind(t)] + change;
    });
    for (std::size_t t = 0; t < multiplicities.size(); ++t)
      if (numbers[behind(t)] != numbers[in_front_of(t)] + multiplicities[t])
        return std::nullopt;
    return numbers;
  }

  // Calls `visit` once for each bounded region, with a triangle between this region and a region
  // visited before, and whether the region is behind the triangle.
  template <class Visit> void visit_regions(const Visit& visit) const {
    std::vector<std::vector<std::size_t>> triangles(m_size); // triangles at each region
    for (std::size_t t = 0; t < m_regions.size() / 2; ++t) {
      triangles[in_front_of(t)].push_back(t);
      triangles[behind(t)].push_back(t);
    }
    std::vector<char> is_known(m_size, 0);
    std::queue<std::size_t> queue;
    is_known[unbounded] = 1;
    for (queue.push(unbounded); !queue.empty(); queue.pop())
      for (std::size_t t : triangles[queue.front()]) {
        const bool to_back = in_front_of(t) == queue.front();
        const std::size_t other = to_back ? behind(t) : in_front_of(t);
        if (is_known[other])
          continue;
        is_known[other] = 1;
        visit(t, to_back);
        queue.push(other);
      }
  }

  // Returns the number of connected components of the triangles that enclose each region.
  const std::vector<int>& depths() const { return m_depths; }

private:
  std::size_t front_side(std::size_t t) const { return 2 * t; }
  std::size_t back_side(std::size_t t) const { return 2 * t + 1; }
  std::size_t infinity() const { return m_regions.size(); } // also a side

  // Joins the facing sides of triangles that are neighbors around an edge: no other triangle is
  // between them.
  void join_at_edges(const Triangle_soup_3& soup, Disjoint_sets& components) {
    // Returns the side of a triangle that is met first in a right-handed rotation about the edge
    // from its first to its second vertex.
    const auto first_side = [&](const Triangle_side& side) {
      const Triangle_indices& t = soup.triangles[side.triangle];
      const std::size_t i = std::find(t.begin(), t.end(), side.vertices[0]) - t.begin();
      return t[(i + 1) % 3] == side.vertices[1] ? back_side(side.triangle)
                                                : front_side(side.triangle);
    };
    std::vector<Triangle_side> sides = sorted_sides(soup.triangles);
    for (auto side = sides.begin(); side != sides.end();) {
      Progress_scope::check();
      const auto end = sides.begin() + (end_of_edge(side, sides.end()) - sides.cbegin());
      std::sort(side, end, Less_around_edge_3(soup, *side));
      for (auto s = side; s != end; ++s) {
        const auto next = s + 1 == end ? side : s + 1;
        m_sets.join(first_side(*s) ^ 1, first_side(*next));
        components.join(s->triangle, next->triangle);
      }
      side = end;
    }
  }

  // Joins the regions of different connected components. The region around a component is found by
  // a ray: it is the region of the next component behind the last crossing with its own.
  void join_components(const Triangle_soup_3& soup, Disjoint_sets& components) {
    std::vector<std::size_t> first; // first triangle of each component
    for (std::size_t t = 0; t < soup.triangles.size(); ++t)
      if (components.find(t) == t)
        first.push_back(t);
    const std::vector<Soup_ray_3> rays = shoot_rays(soup, first);
    std::vector<std::size_t> outsides; // the outermost side of each component
    for (std::size_t p = 0; p < first.size(); ++p) {
      std::size_t outside = rays[p].starts_in_front ? front_side(first[p]) : back_side(first[p]);
      std::size_t beyond = infinity();
      for (const Ray_crossing_3& crossing : rays[p].crossings) {
        const std::size_t t = crossing.triangle;
        if (components.find(t) == first[p]) {
          outside = crossing.leaves_front ? front_side(t) : back_side(t);
          beyond = infinity();
        } else if (beyond == infinity())
          beyond = crossing.leaves_front ? back_side(t) : front_side(t);
      }
      outsides.push_back(outside);
      m_sets.join(outside, beyond);
    }
    count_depths(first, components, outsides);
  }

  // Computes the depths: the regions of a component, except the region around it, are one level
  // deeper than that region.
  void count_depths(const std::vector<std::size_t>& first, Disjoint_sets& components,
                    const std::vector<std::size_t>& outsides) {
    number_regions();
    std::vector<std::vector<std::size_t>> inner(m_size); // regions of the components in each region
    std::vector<std::size_t> outside_of(m_regions.size() / 2); // for first triangles of components
    for (std::size_t p = 0; p < first.size(); ++p)
      outside_of[first[p]] = m_regions[outsides[p]];
    for (std::size_t side = 0; side < m_regions.size(); ++side) {
      const std::size_t outside = outside_of[components.find(side / 2)];
      if (m_regions[side] != outside)
        inner[outside].push_back(m_regions[side]);
    }
    std::vector<char> is_known(m_size, 0);
    m_depths.assign(m_size, 0);
    std::queue<std::size_t> queue;
    is_known[unbounded] = 1;
    for (queue.push(unbounded); !queue.empty(); queue.pop())
      for (std::size_t region : inner[queue.front()])
        if (!is_known[region]) {
          is_known[region] = 1;
          m_depths[region] = m_depths[queue.front()] + 1;
          queue.push(region);
        }
  }

  void number_regions() {
    std::vector<std::size_t> numbers(m_regions.size() + 1, m_regions.size());
    numbers[m_sets.find(infinity())] = unbounded;
    m_size = 1;
    for (std::size_t side = 0; side < m_regions.size(); ++side) {
      std::size_t& number = numbers[m_sets.find(side)];
      if (number == m_regions.size())
        number = m_size++;
      m_regions[side] = number;
    }
  }

  Disjoint_sets m_sets; // sides, and infinity
  std::vector<std::size_t> m_regions;
  std::vector<int> m_depths;
  std::size_t m_size = 0;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_SOUPS_SOUP_REGIONS_3_H
