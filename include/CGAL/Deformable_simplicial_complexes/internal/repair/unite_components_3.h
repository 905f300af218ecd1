// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_REPAIR_UNITE_COMPONENTS_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_REPAIR_UNITE_COMPONENTS_3_H

#include <CGAL/Deformable_simplicial_complexes/internal/repair/Surface_components_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/soups/Soup_regions_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/soups/Triangle_soup_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/soups/split_at_crossings_3.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

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
    Triangle_indices corners = split.triangles[t];
    std::sort(corners.begin(), corners.end());
    const auto [place, is_new] = known.emplace(corners, counted.soup.triangles.size());
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
  const std::optional<Split_soup_3> split = split_at_crossings(components.oriented_soup());
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

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_REPAIR_UNITE_COMPONENTS_3_H
