// Copyright (c) 2026 The deformable simplicial complex authors
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

// A triangle that a ray crosses.
struct Ray_crossing_3
{
  std::size_t triangle;
  bool leaves_front; // the ray goes from the side behind the triangle to the side in front of it
};

// A ray from a point inside a triangle, in the direction of increasing x.
struct Soup_ray_3
{
  bool starts_in_front;                  // of its triangle, and not behind it
  std::vector<Ray_crossing_3> crossings; // along the ray
};

// Rays from points inside the given triangles, which must have an area. Exact. The start of a ray
// is moved by infinitesimal amounts, first in x, then in y, then in z: so no ray meets an edge, and
// none meets its own triangle. Triangles that meet that one where the ray starts may be counted or
// not. n log n, plus the number of triangles whose boxes meet rays.
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
