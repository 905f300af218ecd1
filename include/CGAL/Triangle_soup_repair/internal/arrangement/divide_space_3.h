// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_ARRANGEMENT_DIVIDE_SPACE_3_H
#define CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_ARRANGEMENT_DIVIDE_SPACE_3_H

#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/internal/cgal/cgal_compat.h>
#include <CGAL/Triangle_soup_repair/Invalid_surface_error.h>
#include <CGAL/Triangle_soup_repair/internal/arrangement/Solid_cells_3.h>
#include <CGAL/Triangle_soup_repair/internal/arrangement/split_at_crossings_3.h>
#include <CGAL/Triangle_soup_repair/internal/arrangement/weld_soup_3.h>
#include <CGAL/Triangle_soup_repair/internal/checks/check_surfaces_3.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Triangle_soup_3.h>
#include <CGAL/Triangle_soup_repair/internal/soups/soup_intersections_3.h>

#include <CGAL/Cartesian_converter.h>

#include <charconv>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the number of decimal digits of the shortest text that reads as a number.
inline int decimal_digits(double x) {
  std::array<char, 32> text;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::scientific).ptr;
  return int(std::count_if(text.data(), std::find(text.data(), end, 'e'),
                           [](char c) { return c >= '0' && c <= '9'; }));
}

// Returns a distance that exceeds the rounding of coordinates a few times: points that were
// computed to be in one plane, rotated, and written to a file are nearer to this plane. The
// rounding is that of the file, which may have numbers of type `float` or of a few decimal digits.
// Coordinates with five digits or less are taken for exact.
inline double rounding_distance(const std::vector<Coordinates_3>& points) {
  static constexpr double of_double = 0x1p-40;             // of the largest coordinate
  static constexpr double units = 6;                       // in the last place
  static constexpr int least_digits = 6, most_digits = 12; // more digits are those of `double`
  static constexpr int bits_of_float = 24;
  double largest = 0;
  int digits = 0;
  bool are_floats = true;
  for (const Coordinates_3& p : points)
    for (const double x : p) {
      largest = (std::max)(largest, std::abs(x));
      are_floats = are_floats && double(float(x)) == x;
      if (digits <= most_digits)
        digits = (std::max)(digits, decimal_digits(x));
    }
  if (largest > 0 && digits >= least_digits && digits <= most_digits)
    return units * std::pow(10, std::floor(std::log10(largest)) + 1 - digits);
  if (largest > 0 && are_floats && digits > most_digits)
    return units * std::ldexp(1, std::ilogb(largest) + 1 - bits_of_float);
  return largest * of_double;
}

// Space, divided into the cells that closed surfaces enclose.
struct Divided_space_3
{
  // The cell on each side of a triangle, or `Covering_cells_3::none`.
  struct Sides
  {
    std::size_t behind, in_front;
  };

  Triangle_soup_3 soup;        // triangles meet in common vertices and edges only
  std::vector<Sides> sides;    // of each triangle
  std::vector<double> lengths; // shortest side of the input triangle that contains each triangle
  std::vector<std::size_t> surfaces;                // surface of each cell
  std::vector<std::array<std::size_t, 2>> overlaps; // pairs of surfaces
  std::vector<std::size_t> covered;                 // surfaces of which nothing is left
  double weld_distance;
};

// Returns the triangles of surfaces, which may be open and intersect.
inline Joined_soup_3 join_surfaces(const std::vector<Triangle_soup_3>& surfaces) {
  return join_soups(surfaces, [](const Merged_soup_3&, std::size_t) {});
}

// Returns the given distance, or else that of the rounding.
inline double distance_of(const std::optional<double>& given, const Triangle_soup_3& soup) {
  return given ? *given : rounding_distance(soup.points);
}

// Returns whether features of surfaces are nearer to each other than the weld distance.
inline bool have_contacts(const std::vector<Triangle_soup_3>& surfaces,
                          const std::optional<double>& weld_distance) {
  const Joined_soup_3 joined = join_surfaces(surfaces);
  const double distance = distance_of(weld_distance, joined);
  Split_soup_3 soup = undivided(joined);
  merge_near_points(soup, distance);
  return soup.points != joined.points || Soup_contacts_3(soup, distance).size() > 0;
}

// Throws `Invalid_surface_error` if a surface has a single triangle in an edge.
inline void check_boundaries(const Split_soup_3& soup, const Joined_soup_3& input) {
  struct Boundary
  {
    std::set<std::size_t> facets;
    std::vector<std::size_t> vertices; // ends of edges
  };
  std::map<std::size_t, Boundary> boundaries; // of surfaces
  std::map<Coordinates_3, std::size_t> points;
  for (std::size_t i = 0; i < input.points.size(); ++i)
    points.emplace(input.points[i], input.point_origins[i].index);
  for_each_edge(sorted_sides(soup.triangles), [&](auto side, std::size_t number) {
    const auto vertices = side->vertices;
    std::map<std::size_t, std::vector<std::size_t>> triangles_of; // by surfaces
    for (const auto end = side + number; side != end; ++side) {
      const auto& origin = input.triangle_origins[soup.origins[side->triangle]];
      triangles_of[origin.surface].push_back(origin.index);
    }
    for (const auto& [surface, triangles] : triangles_of)
      if (triangles.size() == 1) {
        Boundary& boundary = boundaries[surface];
        boundary.facets.insert(triangles.front());
        const auto v = points.find(soup.points[vertices[0]]),
                   w = points.find(soup.points[vertices[1]]);
        if (v != points.end() && w != points.end())
          boundary.vertices.insert(boundary.vertices.end(), {v->second, w->second});
      }
  });
  if (!boundaries.empty()) {
    const auto& [surface, boundary] = *boundaries.begin();
    refuse_surface(Invalid_surface_error::Reason::open, surface,
                   {boundary.facets.begin(), boundary.facets.end()}, boundary.vertices);
  }
}

// Returns whether corners of a triangle are on both sides of the plane of another one, farther from
// it than a distance.
inline bool crosses_plane(const Triangle_soup_3& soup, std::size_t triangle, std::size_t of_plane,
                          double distance) {
  const auto plane = exact_triangle(soup, of_plane), crossing = exact_triangle(soup, triangle);
  const auto normal = cross_product(plane[1] - plane[0], plane[2] - plane[0]);
  const double farthest = distance * std::sqrt(normal.squared_length());
  bool is_in_front = false, is_behind = false;
  for (int i = 0; i < 3; ++i) {
    const double height = normal * (crossing[i] - plane[0]);
    is_in_front |= height > farthest;
    is_behind |= height < -farthest;
  }
  return is_in_front && is_behind;
}

// Returns whether triangles cross: along a line that is longer than a distance, and at an angle
// such that corners of both are farther than the distance from the plane of the other one.
inline bool do_cross(const Triangle_soup_3& soup, std::size_t s, std::size_t t, double distance) {
  using Kernel = Exact_predicates_exact_constructions_kernel;
  if (!crosses_plane(soup, s, t, distance) || !crosses_plane(soup, t, s, distance))
    return false;
  const Cartesian_converter<Predicates_kernel, Kernel> exact;
  const auto common = intersection(exact(exact_triangle(soup, s)), exact(exact_triangle(soup, t)));
  const auto* segment = common ? get_alternative<Kernel::Segment_3>(*common) : nullptr;
  return segment && to_double(segment->squared_length()) > square(distance);
}

// Throws `Invalid_surface_error` if triangles of the same surface cross. Parts of a surface that
// touch are permitted, although rounding may make triangles cross there.
// \param origins triangle of the input that contains each triangle
inline void check_self_intersections(const Triangle_soup_3& soup,
                                     const std::vector<std::size_t>& origins,
                                     const Joined_soup_3& input, double distance) {
  std::vector<std::pair<std::size_t, std::size_t>> own;
  for (const auto& [s, t] : crossing_triangles(soup)) {
    const std::size_t a = origins[s], b = origins[t];
    if (input.triangle_origins[a].surface == input.triangle_origins[b].surface &&
        !have_same_corners(soup.triangles[s], soup.triangles[t]) && do_cross(soup, s, t, distance))
      own.push_back(std::minmax(a, b));
  }
  refuse_crossings(input, own);
}

// Splits surfaces where they meet. Throws `Invalid_surface_error` if a surface is open or
// intersects itself. Returns `nullopt` if the distance is too large beside the features.
inline std::optional<Split_soup_3> split_surfaces(const Joined_soup_3& input, double distance) {
  Split_soup_3 welded = undivided(input);
  if (!weld(welded, distance))
    return std::nullopt;
  check_boundaries(welded, input);
  check_self_intersections(welded, welded.origins, input, distance);
  std::optional<Split_soup_3> result = split_at_crossings(
      welded, [distance](Split_soup_3& soup, int) { return weld(soup, distance); });
  if (result)
    for (std::size_t& origin : result->origins)
      origin = welded.origins[origin];
  return result;
}

// Returns the length of the shortest side of a triangle.
inline double shortest_side(const Triangle_soup_3& soup, std::size_t t) {
  const auto triangle = exact_triangle(soup, t);
  double result = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i)
    result = (std::min)(result, squared_distance(triangle[i], triangle[i + 1]));
  return std::sqrt(result);
}

// Returns the space that split surfaces divide.
// \param number number of surfaces
inline Divided_space_3 space_of(const Joined_soup_3& input, const Split_soup_3& split,
                                std::size_t number) {
  std::vector<std::size_t> surface_of;
  for (std::size_t origin : split.origins)
    surface_of.push_back(input.triangle_origins[origin].surface);
  const Shared_soup_3 shared = share_triangles(split, surface_of);
  const Solid_cells_3 cells(shared, number);
  const Covering_cells_3 covering(cells);

  Divided_space_3 result;
  result.soup = shared;
  result.surfaces = cells.surfaces();
  for (std::size_t t : shared.first)
    result.lengths.push_back(shortest_side(input, split.origins[t]));
  for (std::size_t t = 0; t < shared.triangles.size(); ++t)
    result.sides.push_back({covering.in_region(cells.regions().behind(t)),
                            covering.in_region(cells.regions().in_front_of(t))});
  for (const auto& [a, b] : covering.overlaps())
    result.overlaps.push_back({cells.surfaces()[a], cells.surfaces()[b]});
  std::sort(result.overlaps.begin(), result.overlaps.end());
  result.overlaps.erase(std::unique(result.overlaps.begin(), result.overlaps.end()),
                        result.overlaps.end());
  std::vector<char> is_left(number, 0);
  for (std::size_t r = 0; r < cells.regions().size(); ++r)
    if (const std::size_t cell = covering.in_region(r); cell != Covering_cells_3::none)
      is_left[cells.surfaces()[cell]] = 1;
  for (std::size_t s = 0; s < number; ++s)
    if (!is_left[s])
      result.covered.push_back(s);
  return result;
}

// Divides space by closed surfaces. If no distance is given, that of the rounding is tried, and
// others if triangles cannot be welded at this distance, or if nothing is left of a surface, which
// may be thinner. Throws `Invalid_surface_error` if surfaces are open or intersect themselves.
inline Divided_space_3 divide_space(const std::vector<Triangle_soup_3>& surfaces,
                                    const std::optional<double>& weld_distance) {
  const Joined_soup_3 joined = join_surfaces(surfaces);
  const double first = distance_of(weld_distance, joined);
  check_self_intersections(joined, undivided(joined).origins, joined, first);
  std::optional<Divided_space_3> first_result;
  for (const double factor : {1., .25, 4., .0625, 16.}) {
    if (first_result && factor > 1)
      continue;
    if (const auto split = split_surfaces(joined, factor * first)) {
      Divided_space_3 result = space_of(joined, *split, surfaces.size());
      result.weld_distance = factor * first;
      if (weld_distance || result.covered.empty())
        return result;
      if (!first_result)
        first_result = std::move(result);
    }
    if (weld_distance)
      break;
  }
  if (first_result)
    return *first_result;
  throw Error("the weld distance is too large beside the features of the surfaces, or less than "
              "the rounding of their coordinates: give another weld distance");
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_ARRANGEMENT_DIVIDE_SPACE_3_H
