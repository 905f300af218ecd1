// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Triangle_soup_repair, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_CHECKS_REFUSE_SURFACE_H
#define CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_CHECKS_REFUSE_SURFACE_H

#include <CGAL/Triangle_soup_repair/Invalid_surface_error.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

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

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_CHECKS_REFUSE_SURFACE_H
