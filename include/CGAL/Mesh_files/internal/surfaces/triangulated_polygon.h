// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_INTERNAL_SURFACES_TRIANGULATED_POLYGON_H
#define CGAL_MESH_FILES_INTERNAL_SURFACES_TRIANGULATED_POLYGON_H

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

using Polygon_kernel = Exact_predicates_inexact_constructions_kernel;
using Places_of_triangles = std::vector<std::array<std::size_t, 3>>;

// Splits a quadrilateral along one of its diagonals. It chooses the diagonal for which the scalar
// product of the normals of the two triangles is larger.
inline Places_of_triangles
triangulated_quadrilateral(const std::vector<Polygon_kernel::Vector_3>& p) {
  const auto across_1_3 =
      cross_product(p[2] - p[1], p[3] - p[2]) * cross_product(p[0] - p[3], p[1] - p[0]);
  const auto across_0_2 =
      cross_product(p[1] - p[0], p[1] - p[2]) * cross_product(p[3] - p[2], p[3] - p[0]);
  if (across_0_2 > across_1_3)
    return {{2, 3, 0}, {0, 1, 2}};
  return {{3, 0, 1}, {1, 2, 3}};
}

// Returns the constrained Delaunay triangulation of a polygon in the plane. All predicates are
// exact. The result is empty if the polygon is self-intersecting. Intersection points are not
// computed, because there may be millions.
template <class Kernel = Polygon_kernel>
Places_of_triangles
triangulated_simple_polygon(const std::vector<typename Kernel::Point_2>& corners) {
  using Vertex_base = Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
  using Face_base = Constrained_triangulation_face_base_2<
      // whether it is outside
      Kernel, Triangulation_face_base_with_info_2<bool, Kernel>>;
  using Triangulation =
      Constrained_Delaunay_triangulation_2<Kernel,
                                           Triangulation_data_structure_2<Vertex_base, Face_base>,
                                           No_constraint_intersection_tag>;
  if (!is_simple_2(corners.begin(), corners.end()))
    return {};

  Triangulation triangulation;
  std::vector<typename Triangulation::Vertex_handle> vertices;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    vertices.push_back(triangulation.insert(corners[i]));
    vertices[i]->info() = i;
    if (i > 0)
      triangulation.insert_constraint(vertices[i - 1], vertices[i]);
  }
  triangulation.insert_constraint(vertices.back(), vertices.front());
  if (triangulation.dimension() != 2)
    return {};

  for (const auto face : triangulation.all_face_handles())
    face->info() = false;
  std::vector<typename Triangulation::Face_handle> outside = {triangulation.infinite_face()};
  while (!outside.empty()) {
    const auto face = outside.back();
    outside.pop_back();
    if (face->info())
      continue;
    face->info() = true;
    for (int i = 0; i < 3; ++i)
      if (!face->is_constrained(i))
        outside.push_back(face->neighbor(i));
  }
  Places_of_triangles triangles;
  for (const auto face : triangulation.finite_face_handles())
    if (!face->info())
      triangles.push_back(
          {face->vertex(2)->info(), face->vertex(0)->info(), face->vertex(1)->info()});
  return triangles;
}

// Returns the triangles of a polygon, as indices into `corners`. The result is empty if the polygon
// cannot be triangulated. A polygon of more than four corners is projected along its normal, and
// the projection must not be self-intersecting.
template <class Point> Places_of_triangles triangulated_polygon(const std::vector<Point>& corners) {
  using Vector = Polygon_kernel::Vector_3;
  if (corners.size() < 3)
    return {};
  if (corners.size() == 3)
    return {{0, 1, 2}};

  // Coordinates are scaled to unit size, so that products neither overflow nor underflow.
  std::vector<Vector> from_first;
  double size = 0;
  for (const Point& p : corners) {
    from_first.emplace_back(to_double(p.x()) - to_double(corners[0].x()),
                            to_double(p.y()) - to_double(corners[0].y()),
                            to_double(p.z()) - to_double(corners[0].z()));
    for (int i = 0; i < 3; ++i)
      size += std::abs(from_first.back()[i]);
  }
  if (!std::isfinite(size) || size == 0)
    return {};
  for (Vector& p : from_first)
    p = p / size;

  Vector normal = NULL_VECTOR;
  for (std::size_t i = 2; i < corners.size(); ++i)
    normal = normal + cross_product(from_first[i - 1], from_first[i]);
  const double largest =
      (std::max)({std::abs(normal.x()), std::abs(normal.y()), std::abs(normal.z())});
  if (largest == 0)
    return {};
  if (corners.size() == 4)
    return triangulated_quadrilateral(from_first);

  normal = normal / largest;
  const Vector a = std::abs(normal.z()) >= std::abs(normal.y())
                       ? Vector(normal.z(), 0, -normal.x())
                       : Vector(normal.y(), -normal.x(), 0),
               b = cross_product(normal, a);
  std::vector<Polygon_kernel::Point_2> projected;
  for (const Vector& p : from_first)
    projected.emplace_back(a * p, b * p);
  return triangulated_simple_polygon(projected);
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_FILES_INTERNAL_SURFACES_TRIANGULATED_POLYGON_H
