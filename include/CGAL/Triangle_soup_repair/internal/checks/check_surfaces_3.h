// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_CHECKS_CHECK_SURFACES_3_H
#define CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_CHECKS_CHECK_SURFACES_3_H

#include <CGAL/Mesh_support/coordinates.h>
#include <CGAL/Triangle_soup_repair/Invalid_surface_error.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Triangle_soup_3.h>
#include <CGAL/Triangle_soup_repair/internal/soups/soup_intersections_3.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns an explanation of a reason and advice for the user.
inline const char* explanation(Invalid_surface_error::Reason reason) {
  using Reason = Invalid_surface_error::Reason;
  switch (reason) {
  case Reason::empty:
    return "has no facets: give a closed triangle surface";
  case Reason::not_finite:
    return "has coordinates that are not finite: correct or remove these vertices";
  case Reason::bad_index:
    return "has facets with vertices that do not exist: correct these indices";
  case Reason::degenerate_facet:
    return "has facets of area zero: remove them";
  case Reason::open:
    return "is not closed: fill its holes";
  case Reason::non_manifold_edge:
    return "has edges with an odd number of facets, so that inside and outside are undefined: "
           "remove duplicated facets and internal walls";
  case Reason::self_intersection:
    return "intersects itself: components may meet only in common vertices and edges; separate or "
           "unite them";
  case Reason::crossing_surfaces:
    return "intersects another surface: separate them; surfaces may be nested and may share "
           "vertices and edges, but must not cross or share facets";
  case Reason::too_fine:
    return "has vertices that coincide after rounding, relative to the size of all surfaces: use "
           "this surface alone";
  case Reason::outside_enclosing_box:
    return "is not strictly inside the enclosing box: give a larger box";
  case Reason::contradicting_sides:
    return "gives a region another label than a second facet of its boundary: close the gap "
           "between the patches, or exchange the labels of the sides where the orientation of "
           "triangles is reversed";
  }
  return "is invalid";
}

[[noreturn]] inline void refuse_surface(Invalid_surface_error::Reason reason, std::size_t surface,
                                        std::size_t other_surface, std::vector<std::size_t> facets,
                                        std::vector<std::size_t> vertices) {
  std::string message = "surface " + std::to_string(surface) + ' ' + explanation(reason);
  if (!facets.empty())
    message += " (first facet: " + std::to_string(facets.front()) + ')';
  else if (!vertices.empty())
    message += " (first vertex: " + std::to_string(vertices.front()) + ')';
  throw Invalid_surface_error(reason, message, surface, std::move(facets), std::move(vertices),
                              other_surface);
}

[[noreturn]] inline void refuse_surface(Invalid_surface_error::Reason reason, std::size_t surface,
                                        std::vector<std::size_t> facets = {},
                                        std::vector<std::size_t> vertices = {}) {
  refuse_surface(reason, surface, surface, std::move(facets), std::move(vertices));
}

// Checks a soup before any geometric predicate is evaluated. Throws `Invalid_surface_error` if the
// soup has no triangles, coordinates that are not finite, or invalid indices.
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

// Throws `Invalid_surface_error` if triangles are degenerate.
inline void check_areas(const Merged_soup_3& soup, std::size_t surface) {
  std::vector<std::size_t> facets;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    if (exact_triangle(soup, t).is_degenerate())
      facets.push_back(t);
  if (!facets.empty())
    refuse_surface(Invalid_surface_error::Reason::degenerate_facet, surface, std::move(facets));
}

// Throws `Invalid_surface_error` unless each edge has an even number of triangles. Then every path
// from the outside to a given point crosses the same number of triangles modulo 2, and the inside
// is well defined.
inline void check_closedness(const Merged_soup_3& soup, std::size_t surface) {
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

  Offenders open, odd;
  for_each_edge(sorted_sides(soup.triangles), [&](auto side, std::size_t number) {
    if (number % 2 == 0)
      return;
    Offenders& offenders = number == 1 ? open : odd;
    for (std::size_t v : side->vertices)
      offenders.vertices.push_back(soup.input_points[v]);
    for (const auto end = side + number; side != end; ++side)
      offenders.facets.push_back(side->triangle);
  });
  open.refuse(Reason::open, surface);
  odd.refuse(Reason::non_manifold_edge, surface);
}

// Throws `Invalid_surface_error` if pairs of intersecting triangles are given. It reports the first
// surface that intersects itself, or else the first two surfaces that intersect.
inline void refuse_crossings(const Joined_soup_3& soup,
                             const std::vector<std::pair<std::size_t, std::size_t>>& pairs) {
  if (pairs.empty())
    return;

  const std::vector<Joined_soup_3::Origin>& facets = soup.triangle_origins;
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

// Returns the union of soups. Equal points of a soup are merged. Throws `Invalid_surface_error` if
// there are no triangles, coordinates or indices are wrong, or `check_each(soup, index)` throws.
template <class CheckEach>
Joined_soup_3 join_soups(const std::vector<Triangle_soup_3>& soups, const CheckEach& check_each) {
  if (soups.empty())
    refuse_surface(Invalid_surface_error::Reason::empty, 0);
  std::vector<Merged_soup_3> merged;
  for (std::size_t s = 0; s < soups.size(); ++s) {
    check_numbers(soups[s], s);
    merged.push_back(merge_points(soups[s]));
    check_each(merged.back(), s);
  }
  return join(merged);
}

// The same. Throws `Invalid_surface_error` also if triangles are degenerate or intersect in their
// interiors.
template <class CheckEach>
Joined_soup_3 check_soups(const std::vector<Triangle_soup_3>& soups, const CheckEach& check_each) {
  Joined_soup_3 joined = join_soups(soups, [&](const Merged_soup_3& soup, std::size_t s) {
    check_areas(soup, s);
    check_each(soup, s);
  });
  refuse_crossings(joined, crossing_triangles(joined));
  return joined;
}

// Returns the union of closed soups. Equal points of a soup are merged. Throws
// `Invalid_surface_error` unless each soup bounds a solid and no two soups cross. Complexity: O(n
// log n).
inline Joined_soup_3 check_surfaces(const std::vector<Triangle_soup_3>& surfaces) {
  Joined_soup_3 joined = check_soups(surfaces, check_closedness);
  refuse_crossings(joined, crossings_at_edges(joined));
  return joined;
}

// Returns the union of soups, which may be open. Equal points of a soup are merged. Throws
// `Invalid_surface_error` unless triangles meet only in common vertices and edges. Complexity: O(n
// log n).
inline Joined_soup_3 check_patches(const std::vector<Triangle_soup_3>& patches) {
  return check_soups(patches, [](const Merged_soup_3&, std::size_t) {});
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_CHECKS_CHECK_SURFACES_3_H
