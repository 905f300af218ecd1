// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BUILDING_PLANAR_FILLING_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BUILDING_PLANAR_FILLING_2_H

#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>
#include <CGAL/Deformable_simplicial_complexes/internal/building/Curve_soup_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/building/Graded_points_2.h>
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
#include <functional>
#include <memory>
#include <numeric>
#include <optional>
#include <set>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Triangles that fill a box. The segments of the curves are edges of the triangles. The spacing of
// additional points follows the lengths of the nearest segments.
struct Planar_filling_2
{
  using Point = Planar_kernel::Point_2;

  struct Place
  {
    // a triangle that contains the point, on its boundary or inside
    std::optional<std::size_t> triangle;
    bool is_on_segment;
  };

  std::vector<Point> points; // the points of the soup, then additional points
  std::vector<std::array<std::size_t, 3>> triangles;
  std::function<Place(const Point&)> locate; // returns no triangle for a point outside the box
};

template <class Kernel>
using Planar_triangulation_2 = Constrained_Delaunay_triangulation_2<
    Kernel,
    Triangulation_data_structure_2<
        Triangulation_vertex_base_with_info_2<std::size_t, Kernel>,
        Triangulation_face_base_with_info_2<std::size_t, Kernel,
                                            Constrained_triangulation_face_base_2<Kernel>>>,
    No_constraint_intersection_tag>;

// Inserts points in the order of a space-filling curve. Returns their vertices.
template <class Kernel>
std::vector<typename Planar_triangulation_2<Kernel>::Vertex_handle>
insert_points(const std::vector<typename Kernel::Point_2>& points,
              Planar_triangulation_2<Kernel>& triangulation) {
  using Points = typename Pointer_property_map<typename Kernel::Point_2>::const_type;
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  spatial_sort(order.begin(), order.end(),
               Spatial_sort_traits_adapter_2<Kernel, Points>(make_property_map(points.data())));
  std::vector<typename Planar_triangulation_2<Kernel>::Vertex_handle> vertices(points.size());
  typename Planar_triangulation_2<Kernel>::Face_handle near;
  for (std::size_t i : order) {
    Progress_scope::check();
    vertices[i] = triangulation.insert(points[i], near);
    near = vertices[i]->face();
  }
  return vertices;
}

// Triangulates a box like `fill_planar_box()`, without a test for crossings. Curves may end on the
// box. There may be no curve.
// \pre Segments of the curves do not cross.
template <class Kernel = Planar_kernel>
Planar_filling_2 fill_box_between(const Curve_soup_2& soup, const Bbox_2& box) {
  using Point = typename Kernel::Point_2;
  using Triangulation = Planar_triangulation_2<Kernel>;
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
  const auto number = [&](typename Triangulation::Vertex_handle v) {
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
    typename Triangulation::Locate_type type;
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

// Triangulates a box with curves in it. Throws `Invalid_surface_error` if segments cross or
// overlap. Complexity: O(n log n) if few bounding boxes of segments overlap.
template <class Kernel = Planar_kernel>
Planar_filling_2 fill_planar_box(const Curve_soup_2& soup, const Bbox_2& box) {
  check_crossings<Kernel>(soup);
  return fill_box_between<Kernel>(soup, box);
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BUILDING_PLANAR_FILLING_2_H
