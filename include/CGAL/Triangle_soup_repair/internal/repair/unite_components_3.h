// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_REPAIR_UNITE_COMPONENTS_3_H
#define CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_REPAIR_UNITE_COMPONENTS_3_H

#include <CGAL/Triangle_soup_repair/internal/arrangement/split_at_crossings_3.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Soup_regions_3.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Triangle_soup_3.h>
#include <CGAL/Triangle_soup_repair/internal/soups/soup_intersections_3.h>
#include <CGAL/Triangle_soup_repair/internal/soups/soup_rays_3.h>

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
    for_each_edge(m_sides, [&](auto side, std::size_t number) {
      if (number != 2)
        return;
      const bool agrees = runs_forward(side[0]) != runs_forward(side[1]);
      neighbors[side[0].triangle].push_back({side[1].triangle, agrees});
      neighbors[side[1].triangle].push_back({side[0].triangle, agrees});
    });
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
    for_each_edge(m_sides, [&](auto side, std::size_t number) {
      std::map<std::size_t, int> sums;
      for (const auto end = side + number; side != end; ++side)
        sums[m_components[side->triangle]] += runs_forward(*side) ? 1 : -1;
      for (const auto& [component, sum] : sums)
        if (sum != 0)
          m_is_closed[component] = 0;
    });
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

// Distinct triangles with multiplicities: the number of occurrences minus the number of occurrences
// in the opposite orientation.
struct Counted_triangles_3
{
  Triangle_soup_3 soup; // no two triangles have the same corners
  std::vector<int> multiplicities;
  std::vector<char> is_of_closed_components;
  std::vector<std::size_t> of_pieces; // the triangle for each triangle of the split soup
};

// Returns whether the permutation that sorts the corners is even.
inline bool is_even_permutation(const Triangle_indices& t) {
  return (t[0] < t[1]) + (t[1] < t[2]) + (t[2] < t[0]) == 2;
}

inline Counted_triangles_3 count_triangles(const Split_soup_3& split,
                                           const Surface_components_3& components) {
  Counted_triangles_3 counted;
  counted.soup.points = split.points;
  std::map<Triangle_indices, std::size_t> known;
  for (std::size_t t = 0; t < split.triangles.size(); ++t) {
    const auto [place, is_new] =
        known.emplace(sorted(split.triangles[t]), counted.soup.triangles.size());
    if (is_new) {
      counted.soup.triangles.push_back(split.triangles[t]);
      counted.multiplicities.push_back(0);
      counted.is_of_closed_components.push_back(0);
    }
    const std::size_t i = place->second;
    counted.of_pieces.push_back(i);
    if (!components.is_closed(components.of(split.origins[t])))
      continue;
    counted.is_of_closed_components[i] = 1;
    counted.multiplicities[i] +=
        is_even_permutation(split.triangles[t]) == is_even_permutation(counted.soup.triangles[i])
            ? 1
            : -1;
  }
  return counted;
}

// Returns which regions are inside the solid. These are the regions with a positive winding number
// if all dividing triangles belong to closed components and the winding numbers are consistent.
// Otherwise they are the regions enclosed by an odd number of nested components.
inline std::vector<char> solid_regions(const Soup_regions_3& regions,
                                       const Counted_triangles_3& triangles) {
  std::vector<char> result(regions.size());
  bool has_walls = false; // triangles of components that are not closed
  for (std::size_t t = 0; t < triangles.soup.triangles.size(); ++t)
    has_walls |=
        !triangles.is_of_closed_components[t] && regions.in_front_of(t) != regions.behind(t);
  const auto numbers = regions.winding_numbers(triangles.multiplicities);
  for (std::size_t r = 0; r < regions.size(); ++r)
    result[r] = has_walls || !numbers ? regions.depths()[r] % 2 == 1 : (*numbers)[r] > 0;
  return result;
}

struct United_surface_3
{
  Triangle_soup_3 soup;            // corners are counterclockwise seen from outside
  Triangle_soup_3 sheets;          // removed triangles that have the outside on both sides
  std::size_t crossing_pairs;      // pairs of triangles
  std::size_t crossing_components; // components that intersected others or themselves
  std::size_t removed_triangles;   // triangles of the input without any remaining part
};

// Returns the triangles between the solid and the outside, and the triangles with the outside on
// both sides.
inline United_surface_3 boundary_of_solid(const Split_soup_3& split,
                                          const Counted_triangles_3& triangles,
                                          std::size_t size_of_input) {
  const Triangle_soup_3& all = triangles.soup;
  const Soup_regions_3 regions(all);
  const std::vector<char> is_solid = solid_regions(regions, triangles);
  United_surface_3 result = {{all.points, {}}, {all.points, {}}, 0, 0, size_of_input};
  std::vector<char> is_kept(all.triangles.size(), 0);
  for (std::size_t t = 0; t < all.triangles.size(); ++t) {
    Triangle_indices v = all.triangles[t];
    const bool front = is_solid[regions.in_front_of(t)], back = is_solid[regions.behind(t)];
    if (front)
      std::swap(v[1], v[2]);
    is_kept[t] = front != back;
    if (is_kept[t])
      result.soup.triangles.push_back(v);
    else if (!front && !triangles.is_of_closed_components[t])
      result.sheets.triangles.push_back(v);
  }
  std::vector<char> is_left(size_of_input, 0);
  for (std::size_t piece = 0; piece < split.origins.size(); ++piece)
    if (is_kept[triangles.of_pieces[piece]] && !std::exchange(is_left[split.origins[piece]], 1))
      --result.removed_triangles;
  result.soup = merge_points(result.soup);
  return result;
}

// Splits components where they intersect. Features much nearer to each other than the mean edge
// length are welded. If this fails, points are merged after each round instead; surfaces at about
// this distance are then split again with a larger one.
inline std::optional<Split_soup_3> split_components(const Triangle_soup_3& soup) {
  static constexpr double distances[] = {1e-9, 1e-6}; // in mean edges
  const double side = mean_side(soup);
  if (auto result = split_at_crossings(
          soup, [&](Split_soup_3& split, int) { return weld(split, distances[1] * side); }))
    return result;
  for (double distance : distances) {
    const auto merge = [&](Split_soup_3& split, int round) {
      if (round > 0)
        merge_near_points(split, distance * side);
      return true;
    };
    if (auto result = split_at_crossings(soup, merge))
      return result;
  }
  return std::nullopt;
}

// Makes one solid of components that intersect each other or themselves, and removes all triangles
// that do not bound the solid. A closed component is a solid or, if it is nested in an odd number
// of components that it does not intersect, a cavity. A point is in the result if more solids than
// cavities contain it. Triangles of no closed component may divide space, such as walls inside a
// solid. In this case everything they enclose is in the result, except nested cavities.
//
// The triangles of the result meet in common vertices and edges only, with an even number of
// triangles in each edge. Returns `nullopt` if there is no such solid.
// \pre no triangle is degenerate
inline std::optional<United_surface_3> unite_components(const Triangle_soup_3& input) {
  const Surface_components_3 components(input);
  const auto split = split_components(components.oriented_soup());
  if (!split)
    return std::nullopt;
  United_surface_3 result =
      boundary_of_solid(*split, count_triangles(*split, components), input.triangles.size());
  if (result.soup.triangles.empty())
    return std::nullopt;
  result.crossing_pairs = components.number_of_crossing_pairs();
  result.crossing_components = components.number_of_crossing_components();
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_REPAIR_UNITE_COMPONENTS_3_H
