// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_SOUPS_SOUP_RAYS_3_H
#define CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_SOUPS_SOUP_RAYS_3_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Triangle_soup_3.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/enum.h>

#include <limits>

namespace CGAL::Deformable_simplicial_complexes::internal {

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

// A ray in the direction of increasing x. Its start is perturbed by infinitesimal amounts: by d in
// x, e in y and f in z, where 1 >> d >> e >> f > 0.
template <class Kernel_> class Perturbed_ray_3
{
public:
  using Kernel = Kernel_;
  using FT = typename Kernel::FT;
  using Point = typename Kernel::Point_3;
  using Triangle = std::array<Point, 3>;

  // Starts the ray at a point inside the triangle. The weights of the corners are no simple
  // fractions, to avoid degenerate positions.
  explicit Perturbed_ray_3(const Triangle& t)
      : m_start(ORIGIN + (weights[0] * (t[0] - ORIGIN) + weights[1] * (t[1] - ORIGIN) +
                          (1 - weights[0] - weights[1]) * (t[2] - ORIGIN))) {}

  const Point& start() const { return m_start; }

  // Returns whether the perturbation moves the start to the front of the triangle.
  static bool starts_in_front(const Triangle& t) {
    for (int axis = 0; axis < 3; ++axis)
      if (const Orientation o = projected_orientation(t[0], t[1], t[2], axis); o != COLLINEAR)
        return o == POSITIVE;
    return true; // a degenerate triangle
  }

  // Returns the orientation of the triangle seen against the direction of the ray if the ray
  // crosses the triangle, COLLINEAR otherwise.
  Orientation crossing(const Triangle& t) const {
    const Orientation o = projected_orientation(t[0], t[1], t[2], 0);
    if (o == COLLINEAR)
      return COLLINEAR;
    for (int i = 0; i < 3; ++i)
      if (side(t[i], t[(i + 1) % 3]) != o)
        return COLLINEAR;
    const Orientation from_start = orientation(t[0], t[1], t[2], m_start);
    return from_start == opposite(o) ? o : COLLINEAR;
  }

  // Returns the x-coordinate of the crossing with a triangle, and its derivatives by y and z of the
  // start. The lexicographic order is the order of the crossings along the ray.
  std::array<FT, 3> place(const Triangle& t) const {
    const typename Kernel::Plane_3 plane(t[0], t[1], t[2]);
    return {-(plane.b() * m_start.y() + plane.c() * m_start.z() + plane.d()) / plane.a(),
            -plane.b() / plane.a(), -plane.c() / plane.a()};
  }

private:
  static constexpr double weights[] = {79. / 256, 263. / 1024}; // exact, like their sum

  // Returns the orientation of the projection of a triangle along an axis.
  static Orientation projected_orientation(const Point& a, const Point& b, const Point& c,
                                           int axis) {
    using Point_2 = typename Kernel::Point_2;
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    return orientation(Point_2(a[i], a[j]), Point_2(b[i], b[j]), Point_2(c[i], c[j]));
  }

  // Returns the side of the line from a to b on which the ray lies, seen against the direction of
  // the ray.
  Orientation side(const Point& a, const Point& b) const {
    if (const Orientation o = projected_orientation(a, b, m_start, 0); o != COLLINEAR)
      return o;
    const Comparison_result z = compare(a.z(), b.z());
    return z != EQUAL ? z : compare(b.y(), a.y());
  }

  Point m_start;
};

// Returns rays from points inside the given triangles. Exact. The start of a ray is perturbed by
// infinitesimal amounts, first in x, then in y, then in z, so that no ray meets an edge, and no ray
// meets its own triangle. Triangles that meet this triangle at the start of the ray may be counted
// or not. Takes time O(n log n), plus the number of triangles whose bounding boxes meet rays.
// \pre the given triangles are not degenerate
template <class Kernel = Exact_predicates_exact_constructions_kernel>
std::vector<Soup_ray_3> shoot_rays(const Triangle_soup_3& soup,
                                   const std::vector<std::size_t>& triangles) {
  using Ray = Perturbed_ray_3<Kernel>;
  const auto triangle = [&soup](std::size_t t) {
    typename Ray::Triangle result;
    for (std::size_t i = 0; i < 3; ++i) {
      const Coordinates_3& p = soup.points[soup.triangles[t][i]];
      result[i] = {p[0], p[1], p[2]};
    }
    return result;
  };
  using Box = Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;
  std::vector<Ray> rays;
  std::vector<Box> starts, boxes;
  for (std::size_t r = 0; r < triangles.size(); ++r) {
    rays.emplace_back(triangle(triangles[r]));
    const Bbox_3 box = rays.back().start().bbox();
    starts.emplace_back(Bbox_3(box.xmin(), box.ymin(), box.zmin(),
                               std::numeric_limits<double>::infinity(), box.ymax(), box.zmax()),
                        r);
  }
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    boxes.emplace_back(exact_triangle(soup, t).bbox(), t);

  struct Hit
  {
    std::array<typename Kernel::FT, 3> place;
    std::size_t triangle;
    bool leaves_front;
  };
  std::vector<std::vector<Hit>> hits(rays.size());
  box_intersection_d(
      starts.begin(), starts.end(), boxes.begin(), boxes.end(), [&](const Box& r, const Box& t) {
        Progress_scope::check();
        if (t.info() == triangles[r.info()])
          return;
        const auto corners = triangle(t.info());
        const Orientation o = rays[r.info()].crossing(corners);
        if (o != COLLINEAR)
          hits[r.info()].push_back({rays[r.info()].place(corners), t.info(), o == POSITIVE});
      });

  std::vector<Soup_ray_3> result;
  for (std::size_t r = 0; r < rays.size(); ++r) {
    auto& along = hits[r];
    std::sort(along.begin(), along.end(), [](const Hit& a, const Hit& b) {
      return a.place != b.place ? a.place < b.place : a.triangle < b.triangle;
    });
    result.push_back({Ray::starts_in_front(triangle(triangles[r])), {}});
    for (const Hit& hit : along)
      result.back().crossings.push_back({hit.triangle, hit.leaves_front});
  }
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_SOUPS_SOUP_RAYS_3_H
