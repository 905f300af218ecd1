// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IO_TRIANGULATED_POLYGON_IMPL_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IO_TRIANGULATED_POLYGON_IMPL_H

#include <CGAL/Deformable_simplicial_complexes/internal/IO/triangulated_polygon.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

Places_of_triangles
triangulated_simple_polygon(const std::vector<Polygon_kernel::Point_2>& corners) {
  using Vertex_base = Triangulation_vertex_base_with_info_2<std::size_t, Polygon_kernel>;
  using Face_base = Constrained_triangulation_face_base_2<
      // whether it is outside
      Polygon_kernel, Triangulation_face_base_with_info_2<bool, Polygon_kernel>>;
  using Triangulation =
      Constrained_Delaunay_triangulation_2<Polygon_kernel,
                                           Triangulation_data_structure_2<Vertex_base, Face_base>,
                                           No_constraint_intersection_tag>;
  if (!is_simple_2(corners.begin(), corners.end()))
    return {};

  Triangulation triangulation;
  std::vector<Triangulation::Vertex_handle> vertices;
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
  std::vector<Triangulation::Face_handle> outside = {triangulation.infinite_face()};
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

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IO_TRIANGULATED_POLYGON_IMPL_H
