// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_BUILDING_PLANAR_FILLING_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_BUILDING_PLANAR_FILLING_2_H

#include <CGAL/Deformable_simplicial_complex_2/internal/building/Curve_soup_2.h>
#include <CGAL/Deformable_simplicial_complex_2/internal/building/Graded_points_2.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Triangles that fill a box, with the segments of curves among their edges, and points as dense as
// those of the curves near them.
class Planar_filling_2
{
public:
  using Point = Planar_kernel::Point_2;

  Planar_filling_2(const Curve_soup_2& soup, const Bbox_2& box) {
    std::vector<Triangulation::Vertex_handle> handles;
    for (const Point& p : soup.points)
      handles.push_back(m_triangulation.insert(p));
    std::set<std::array<std::size_t, 2>> segments; // each once, though several curves may have it
    for (const auto& wall : soup.walls)
      if (segments.insert(wall.vertices).second)
        m_triangulation.insert_constraint(handles[wall.vertices[0]], handles[wall.vertices[1]]);
    const Graded_points_2 graded(soup, box);
    m_triangulation.insert(graded.points().begin(), graded.points().end());

    for (auto v : m_triangulation.finite_vertex_handles())
      v->info() = none;
    const auto number = [&](Triangulation::Vertex_handle v) {
      if (v->info() == none) {
        v->info() = points.size();
        points.push_back(v->point());
      }
    };
    for (auto v : handles)
      number(v);
    for (auto v : m_triangulation.finite_vertex_handles())
      number(v);
    for (auto f : m_triangulation.finite_face_handles()) {
      f->info() = triangles.size();
      triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
    }
  }

  // A triangle with a point in it or on its boundary; nothing outside the box.
  std::optional<std::size_t> locate(const Point& p) const {
    const auto f = m_triangulation.locate(p);
    if (f == nullptr || m_triangulation.is_infinite(f))
      return std::nullopt;
    return f->info();
  }

  // Whether a point is on one of the segments.
  bool is_on_segment(const Point& p) const {
    Triangulation::Locate_type type;
    int i;
    const auto f = m_triangulation.locate(p, type, i);
    if (type == Triangulation::VERTEX)
      return m_triangulation.are_there_incident_constraints(f->vertex(i));
    return type == Triangulation::EDGE && f->is_constrained(i);
  }

  std::vector<Point> points; // of the soup, then others
  std::vector<std::array<std::size_t, 3>> triangles;

private:
  static constexpr std::size_t none = std::size_t(-1);
  using Vertex = Triangulation_vertex_base_with_info_2<std::size_t, Planar_kernel>;
  using Face =
      Triangulation_face_base_with_info_2<std::size_t, Planar_kernel,
                                          Constrained_triangulation_face_base_2<Planar_kernel>>;
  using Triangulation = Constrained_Delaunay_triangulation_2<
      Planar_kernel, Triangulation_data_structure_2<Vertex, Face>, No_constraint_intersection_tag>;

  Triangulation m_triangulation;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_BUILDING_PLANAR_FILLING_2_H
