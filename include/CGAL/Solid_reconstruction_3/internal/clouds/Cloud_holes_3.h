// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Solid_reconstruction_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_CLOUDS_CLOUD_HOLES_3_H
#define CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_CLOUDS_CLOUD_HOLES_3_H

#include <CGAL/Deformable_simplicial_complexes/cgal_compat.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/Cloud_sides_3.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/local_fits_3.h>

#include <CGAL/AABB_tree.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The holes of a point cloud: Delaunay facets between the inside and the outside with an edge that
// is long compared with the distances of its points from their sixth neighbors.
class Cloud_holes_3
{
public:
  explicit Cloud_holes_3(const std::vector<Cloud_sides_3::Boundary_facet>& boundary) {
    static constexpr double longest = 3; // reaches; longer than gaps of random points
    double whole = 0, open = 0;          // areas
    for (const auto& facet : boundary) {
      const Triangle t(point(facet.points[0]), point(facet.points[1]), point(facet.points[2]));
      const double area = std::sqrt(t.squared_area()), bound = longest * facet.reach;
      double edge = 0; // squared length of the longest edge
      for (int k = 0; k < 3; ++k)
        edge = (std::max)(edge, (t[k] - t[k + 1]).squared_length());
      whole += area;
      if (!(edge > bound * bound) || !(area > 0))
        continue;
      open += area;
      m_triangles.push_back(t);
    }
    m_share = whole > 0 ? open / whole : 0;
    m_tree.insert(m_triangles.cbegin(), m_triangles.cend());
    m_tree.build();
    if (!m_triangles.empty())
      m_tree.accelerate_distance_queries(); // before threads query the tree
  }

  Cloud_holes_3(const Cloud_holes_3&) = delete; // the tree refers to the triangles
  Cloud_holes_3& operator=(const Cloud_holes_3&) = delete;

  // Returns the part of the boundary of the inside that has no points, by area.
  double share() const { return m_share; }
  bool meets(const Cloud_sides_3::Ball& ball) const {
    return !m_triangles.empty() &&
           m_tree.squared_distance(point(ball.center)) < ball.squared_radius;
  }

private:
  using Triangle = Cloud_kernel::Triangle_3;
  using Triangles = std::vector<Triangle>;

  static Cloud_kernel::Point_3 point(const Cloud_sides_3::Point& p) {
    return {p.x(), p.y(), p.z()};
  }

  Triangles m_triangles;
  AABB_tree<Tree_traits_3<Cloud_kernel, Triangles::const_iterator>> m_tree;
  double m_share = 0;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_CLOUDS_CLOUD_HOLES_3_H
