// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_BUILDING_PLANAR_FILLING_2_IMPL_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_BUILDING_PLANAR_FILLING_2_IMPL_H

#include <CGAL/Deformable_simplicial_complex_2/internal/building/Curve_soup_2.h>
#include <CGAL/Deformable_simplicial_complex_2/internal/building/Graded_points_2.h>
#include <CGAL/Deformable_simplicial_complex_2/internal/building/Planar_filling_2.h>
#include <CGAL/Deformable_simplicial_complex_2/internal/building/curve_crossings_2.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <array>
#include <cstddef>
#include <memory>
#include <set>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

Planar_filling_2 fill_planar_box(const Curve_soup_2& soup, const Bbox_2& box) {
  using Point = Planar_kernel::Point_2;
  using Vertex = Triangulation_vertex_base_with_info_2<std::size_t, Planar_kernel>;
  using Face =
      Triangulation_face_base_with_info_2<std::size_t, Planar_kernel,
                                          Constrained_triangulation_face_base_2<Planar_kernel>>;
  using Triangulation = Constrained_Delaunay_triangulation_2<
      Planar_kernel, Triangulation_data_structure_2<Vertex, Face>, No_constraint_intersection_tag>;
  static constexpr std::size_t none = std::size_t(-1);

  check_crossings(soup);
  const auto triangulation = std::make_shared<Triangulation>();
  std::vector<Triangulation::Vertex_handle> handles;
  for (const Point& p : soup.points)
    handles.push_back(triangulation->insert(p));
  std::set<std::array<std::size_t, 2>> segments; // each once, though several curves may have it
  for (const auto& wall : soup.walls)
    if (segments.insert(wall.vertices).second)
      triangulation->insert_constraint(handles[wall.vertices[0]], handles[wall.vertices[1]]);
  const Graded_points_2 graded(soup, box);
  triangulation->insert(graded.points().begin(), graded.points().end());

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

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_BUILDING_PLANAR_FILLING_2_IMPL_H
