// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_BUILDING_CHECK_SURFACES_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_BUILDING_CHECK_SURFACES_3_H

#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/building/Triangle_soup_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/coordinates.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/building/refuse_surface.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/building/soup_intersections_3.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// What has to be right before anything else can be asked for.
inline void check_numbers(const Triangle_soup_3& soup, std::size_t surface) {
  using Reason = Invalid_surface_error::Reason;
  if (soup.triangles.empty())
    refuse_surface(Reason::empty, surface);

  std::vector<std::size_t> vertices;
  for (std::size_t i = 0; i < soup.points.size(); ++i)
    if (!has_finite_coordinates(soup.points[i]))
      vertices.push_back(i);
  if (!vertices.empty())
    refuse_surface(Reason::not_finite, surface, {}, std::move(vertices));

  std::vector<std::size_t> facets;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    const Triangle_indices& v = soup.triangles[t];
    if (*std::max_element(v.begin(), v.end()) >= soup.points.size())
      facets.push_back(t);
  }
  if (!facets.empty())
    refuse_surface(Reason::bad_index, surface, std::move(facets));
}

inline void check_areas(const Merged_soup_3& soup, std::size_t surface) {
  std::vector<std::size_t> facets;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    if (exact_triangle(soup, t).is_degenerate())
      facets.push_back(t);
  if (!facets.empty())
    refuse_surface(Invalid_surface_error::Reason::degenerate_facet, surface, std::move(facets));
}

// One side of a triangle. Corner i of triangle t has index 3 t + i.
struct Triangle_side
{
  std::array<std::size_t, 2> vertices; // increasing
  std::array<std::size_t, 2> corners;  // of these vertices

  std::size_t triangle() const { return corners[0] / 3; }
};

// The sides of all triangles, those along one edge next to each other.
inline std::vector<Triangle_side> sorted_sides(const std::vector<Triangle_indices>& triangles) {
  std::vector<Triangle_side> sides;
  sides.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      std::size_t j = i, k = (i + 1) % 3;
      if (triangles[t][j] > triangles[t][k])
        std::swap(j, k);
      sides.push_back({{triangles[t][j], triangles[t][k]}, {3 * t + j, 3 * t + k}});
    }
  std::sort(sides.begin(), sides.end(), [](const Triangle_side& a, const Triangle_side& b) {
    return a.vertices != b.vertices ? a.vertices < b.vertices : a.corners < b.corners;
  });
  return sides;
}

// Each edge must have two triangles, and the triangles at a vertex must form one fan: its corners
// must be connected across edges.
inline void check_manifoldness(const Merged_soup_3& soup, std::size_t surface) {
  struct Offenders
  {
    std::vector<std::size_t> facets, vertices;

    void refuse(Invalid_surface_error::Reason reason, std::size_t surface) {
      if (facets.empty())
        return;
      std::sort(facets.begin(), facets.end());
      facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
      refuse_surface(reason, surface, std::move(facets), std::move(vertices));
    }
  };
  using Reason = Invalid_surface_error::Reason;

  Offenders open, crowded;
  const std::size_t number_of_corners = 3 * soup.triangles.size();
  boost::disjoint_sets_with_storage<> fans(number_of_corners);
  const std::vector<Triangle_side> sides = sorted_sides(soup.triangles);
  for (auto side = sides.begin(); side != sides.end();) {
    const auto end = std::find_if(
        side, sides.end(), [side](const Triangle_side& s) { return s.vertices != side->vertices; });
    if (end - side == 2) {
      fans.union_set(side->corners[0], (side + 1)->corners[0]);
      fans.union_set(side->corners[1], (side + 1)->corners[1]);
    } else {
      Offenders& offenders = end - side == 1 ? open : crowded;
      for (std::size_t v : side->vertices)
        offenders.vertices.push_back(soup.input_points[v]);
      std::for_each(side, end, [&offenders](const Triangle_side& s) {
        offenders.facets.push_back(s.triangle());
      });
    }
    side = end;
  }
  open.refuse(Reason::open, surface);
  crowded.refuse(Reason::non_manifold_edge, surface);

  Offenders touching;
  std::vector<std::size_t> fan_of(soup.points.size(), number_of_corners);
  std::vector<char> has_fans(soup.points.size(), 0);
  for (std::size_t c = 0; c < number_of_corners; ++c) {
    const std::size_t v = soup.triangles[c / 3][c % 3], fan = fans.find_set(c);
    if (fan_of[v] == number_of_corners)
      fan_of[v] = fan;
    has_fans[v] |= fan_of[v] != fan;
  }
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    if (has_fans[v])
      touching.vertices.push_back(soup.input_points[v]);
  for (std::size_t c = 0; c < number_of_corners; ++c)
    if (has_fans[soup.triangles[c / 3][c % 3]])
      touching.facets.push_back(c / 3);
  touching.refuse(Reason::non_manifold_vertex, surface);
}

// Refuses the first surface that meets itself, or else the first two that meet.
inline void check_intersections(const std::vector<Merged_soup_3>& soups) {
  struct Facet
  {
    std::size_t surface, index;
  };
  Triangle_soup_3 all;
  std::vector<Facet> facets;
  for (std::size_t s = 0; s < soups.size(); ++s) {
    append(all, soups[s]);
    for (std::size_t t = 0; t < soups[s].triangles.size(); ++t)
      facets.push_back({s, t});
  }
  const auto pairs = crossing_triangles(all);
  if (pairs.empty())
    return;

  using Surfaces = std::array<std::size_t, 2>;
  const auto surfaces = [&](const std::pair<std::size_t, std::size_t>& pair) -> Surfaces {
    return {facets[pair.first].surface, facets[pair.second].surface};
  };
  Surfaces first = surfaces(pairs.front());
  for (const auto& pair : pairs) {
    const Surfaces s = surfaces(pair);
    const bool s_differ = s[0] != s[1], first_differ = first[0] != first[1];
    if (s_differ != first_differ ? first_differ : s < first)
      first = s;
  }
  std::vector<std::size_t> offenders;
  for (const auto& pair : pairs)
    if (surfaces(pair) == first) {
      offenders.push_back(facets[pair.first].index);
      offenders.push_back(facets[pair.second].index);
    }
  using Reason = Invalid_surface_error::Reason;
  refuse_surface(first[0] == first[1] ? Reason::self_intersection : Reason::crossing_surfaces,
                 first[0], first[1], std::move(offenders), {});
}

// Throws Invalid_surface_error unless each soup, its equal points merged, bounds a solid, and no
// two of them meet. Returns the merged soups. n log n.
inline std::vector<Merged_soup_3> check_surfaces(const std::vector<Triangle_soup_3>& surfaces) {
  if (surfaces.empty())
    refuse_surface(Invalid_surface_error::Reason::empty, 0);
  std::vector<Merged_soup_3> merged;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    check_numbers(surfaces[s], s);
    merged.push_back(merge_points(surfaces[s]));
    check_areas(merged.back(), s);
    check_manifoldness(merged.back(), s);
  }
  check_intersections(merged);
  return merged;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_BUILDING_CHECK_SURFACES_3_H
