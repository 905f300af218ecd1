// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BUILDING_PLANAR_FILLING_2_IMPL_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BUILDING_PLANAR_FILLING_2_IMPL_H

#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>
#include <CGAL/Deformable_simplicial_complexes/internal/building/Curve_soup_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/building/Graded_points_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/building/Planar_filling_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/building/curve_crossings_2.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <array>
#include <cstddef>
#include <memory>
#include <numeric>
#include <set>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

using Planar_triangulation_2 = Constrained_Delaunay_triangulation_2<
    Planar_kernel,
    Triangulation_data_structure_2<
        Triangulation_vertex_base_with_info_2<std::size_t, Planar_kernel>,
        Triangulation_face_base_with_info_2<std::size_t, Planar_kernel,
                                            Constrained_triangulation_face_base_2<Planar_kernel>>>,
    No_constraint_intersection_tag>;

// Inserts points in the order of a space-filling curve. Returns their vertices.
inline std::vector<Planar_triangulation_2::Vertex_handle>
insert_points(const std::vector<Planar_kernel::Point_2>& points,
              Planar_triangulation_2& triangulation) {
  using Points = Pointer_property_map<Planar_kernel::Point_2>::const_type;
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  spatial_sort(
      order.begin(), order.end(),
      Spatial_sort_traits_adapter_2<Planar_kernel, Points>(make_property_map(points.data())));
  std::vector<Planar_triangulation_2::Vertex_handle> vertices(points.size());
  Planar_triangulation_2::Face_handle near;
  for (std::size_t i : order) {
    Progress_scope::check();
    vertices[i] = triangulation.insert(points[i], near);
    near = vertices[i]->face();
  }
  return vertices;
}

Planar_filling_2 fill_planar_box(const Curve_soup_2& soup, const Bbox_2& box) {
  check_crossings(soup);
  return fill_box_between(soup, box);
}

Planar_filling_2 fill_box_between(const Curve_soup_2& soup, const Bbox_2& box) {
  using Point = Planar_kernel::Point_2;
  using Triangulation = Planar_triangulation_2;
  static constexpr std::size_t none = std::size_t(-1);

  const Progress_phase phase("filling the box with triangles");
  const auto triangulation = std::make_shared<Triangulation>();
  const auto handles = insert_points(soup.points, *triangulation);
  // without duplicates, because several curves may contain the same segment
  std::set<std::array<std::size_t, 2>> segments;
  for (const auto& wall : soup.walls) {
    Progress_scope::check();
    if (segments.insert(wall.vertices).second)
      triangulation->insert_constraint(handles[wall.vertices[0]], handles[wall.vertices[1]]);
  }
  insert_points(Graded_points_2(soup, box).points(), *triangulation);

  Planar_filling_2 filling;
  for (auto v : triangulation->finite_vertex_handles())
    v->info() = none;
  const auto number = [&](Triangulation::Vertex_handle v) {
    if (v->info() == none) {
      v->info() = filling.points.size();
      filling.points.push_back(v->point());
    }
  };
  for (auto v : handles)
    number(v);
  for (auto v : triangulation->finite_vertex_handles())
    number(v);
  for (auto f : triangulation->finite_face_handles()) {
    f->info() = filling.triangles.size();
    filling.triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  }
  filling.locate = [triangulation](const Point& p) -> Planar_filling_2::Place {
    Triangulation::Locate_type type;
    int i;
    const auto f = triangulation->locate(p, type, i);
    if (f == nullptr || triangulation->is_infinite(f))
      return {{}, false};
    return {f->info(), type == Triangulation::VERTEX
                           ? triangulation->are_there_incident_constraints(f->vertex(i))
                           : type == Triangulation::EDGE && f->is_constrained(i)};
  };
  return filling;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BUILDING_PLANAR_FILLING_2_IMPL_H
