// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_MISPLACED_BALLS_3_H
#define CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_MISPLACED_BALLS_3_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/internal/cgal/cgal_compat.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/Sampled_surface_3.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The inside of closed triangles, by the number of triangles that rays intersect.
class Closed_triangles_3
{
public:
  using Point = Cloud_kernel::Point_3;
  using Triangles = std::vector<Cloud_kernel::Triangle_3>;

  explicit Closed_triangles_3(const Triangles& triangles)
      : m_tree(triangles.begin(), triangles.end()) {
    m_tree.build(); // before threads query the tree
    if (!triangles.empty()) {
      const Bbox_3 box = m_tree.bbox();
      m_extent =
          (std::max)({box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
    }
  }

  // Returns whether rays in three directions agree that a point is inside, or outside. One ray may
  // count wrongly if it meets an edge.
  bool is_certainly(bool inside, const Point& p) const {
    return std::all_of(directions().begin(), directions().end(), [&](const auto& direction) {
      const Cloud_kernel::Ray_3 ray(p, m_extent * direction);
      return (m_tree.number_of_intersected_primitives(ray) % 2 != 0) == inside;
    });
  }

private:
  // Returns directions that are not parallel to edges of common shapes.
  static const std::array<Cloud_kernel::Vector_3, 3>& directions() {
    static const std::array<Cloud_kernel::Vector_3, 3> result = {
        {{.4379, .6218, .6494}, {-.7127, .2816, .6425}, {.2311, -.8839, .4066}}};
    return result;
  }

  AABB_tree<Tree_traits_3<Cloud_kernel, Triangles::const_iterator>> m_tree;
  double m_extent = 1; // of the triangles; a ray is given by two points at this distance
};

// Returns the centers of the balls of known side that lie on the other side of closed triangles.
// Balls are sorted by decreasing radius. A ball whose center is in a larger ball of the result is
// omitted.
inline std::vector<Cloud_kernel::Point_3>
misplaced_balls(const Sampled_surface_3& surface, const Closed_triangles_3::Triangles& triangles) {
  const Closed_triangles_3 solid(triangles);
  std::vector<Cloud_sides_3::Certain_ball> balls = surface.known_balls();
  const auto center = [&](std::size_t i) {
    const auto& p = balls[i].ball.center;
    return Cloud_kernel::Point_3(p.x(), p.y(), p.z());
  };
  std::vector<char> is_misplaced(balls.size());
  surface.cloud().for_each()(balls.size(), [&](std::size_t i) {
    Progress_scope::check();
    is_misplaced[i] = solid.is_certainly(!balls[i].is_inside, center(i));
  });
  keep_marked(balls, is_misplaced);
  std::stable_sort(balls.begin(), balls.end(), [](const auto& a, const auto& b) {
    return a.ball.squared_radius > b.ball.squared_radius;
  });
  std::vector<std::size_t> largest;
  for (std::size_t i = 0; i < balls.size(); ++i)
    if (std::none_of(largest.begin(), largest.end(), [&](std::size_t k) {
          return (center(i) - center(k)).squared_length() < balls[k].ball.squared_radius;
        }))
      largest.push_back(i);
  std::vector<Cloud_kernel::Point_3> result;
  for (std::size_t i : largest)
    result.push_back(center(i));
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_RECONSTRUCTION_MISPLACED_BALLS_3_H
