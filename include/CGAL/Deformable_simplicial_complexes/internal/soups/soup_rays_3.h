// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_SOUPS_SOUP_RAYS_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_SOUPS_SOUP_RAYS_3_H

#include <CGAL/Deformable_simplicial_complexes/internal/soups/Triangle_soup_3.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// The crossing of a triangle by a ray.
struct Ray_crossing_3
{
  std::size_t triangle;
  bool leaves_front; // whether it goes from behind the triangle to its front
};

// A ray from a point inside a triangle, in the direction of increasing x.
struct Soup_ray_3
{
  bool starts_in_front;                  // whether the ray starts in front of its triangle
  std::vector<Ray_crossing_3> crossings; // sorted along the ray
};

// Returns rays from points inside the given triangles. Exact. The start of a ray is perturbed by
// infinitesimal amounts, first in x, then in y, then in z, so that no ray meets an edge, and no ray
// meets its own triangle. Triangles that meet this triangle at the start of the ray may be counted
// or not. Takes time O(n log n), plus the number of triangles whose bounding boxes meet rays.
// \pre the given triangles are not degenerate
#ifdef CGAL_DSC_EXTERN // see the component Compiled
std::vector<Soup_ray_3> shoot_rays(const Triangle_soup_3& soup,
                                   const std::vector<std::size_t>& triangles);
#else
inline std::vector<Soup_ray_3> shoot_rays(const Triangle_soup_3& soup,
                                          const std::vector<std::size_t>& triangles);
#endif

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#ifndef CGAL_DSC_EXTERN
#include <CGAL/Deformable_simplicial_complexes/internal/soups/soup_rays_3_impl.h>
#endif

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_SOUPS_SOUP_RAYS_3_H
