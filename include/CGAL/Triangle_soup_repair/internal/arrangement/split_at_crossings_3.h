// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_ARRANGEMENT_SPLIT_AT_CROSSINGS_3_H
#define CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_ARRANGEMENT_SPLIT_AT_CROSSINGS_3_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/internal/cgal/cgal_compat.h>
#include <CGAL/Triangle_soup_repair/internal/arrangement/weld_soup_3.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Triangle_soup_3.h>
#include <CGAL/Triangle_soup_repair/internal/soups/soup_intersections_3.h>

#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <optional>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Traits of triangulations whose flips wait for certainty: points that nearly lie on a circle count
// as points on it. The triangulation is then nearly Delaunay, and no exact number is computed for
// it.
template <class Kernel> struct Nearly_delaunay_traits_2 : Kernel
{
  struct Side_of_oriented_circle_2
  {
    using result_type = Oriented_side;

    template <class Point>
    Oriented_side operator()(const Point& p, const Point& q, const Point& r, const Point& s) const {
      const Protect_FPU_rounding<true> interval_arithmetic;
      const auto side = typename Kernel::Approximate_kernel().side_of_oriented_circle_2_object()(
          approx(p), approx(q), approx(r), approx(s));
      return is_certain(side) ? get_certain(side) : ON_ORIENTED_BOUNDARY;
    }
  };

  Side_of_oriented_circle_2 side_of_oriented_circle_2_object() const { return {}; }
};

// A triangle to be triangulated again, with points and segments inserted into it. All computations
// are exact, in the projection along an axis that is not parallel to the triangle.
template <class Kernel_> class Split_triangle_3
{
public:
  using Kernel = Kernel_;
  using Point = typename Kernel::Point_3;

  explicit Split_triangle_3(const std::array<Coordinates_3, 3>& corners)
      : m_points(corners.begin(), corners.end()), m_axis(axis_of_projection()),
        m_triangle(exact_corner(0), exact_corner(1), exact_corner(2)) {
    for (int i = 0; i < 3; ++i)
      m_triangulation.insert(project(m_triangle[i]))->index() = i;
    for (int i = 0; i < 3; ++i)
      insert(m_triangle[i], m_triangle[i + 1]);
  }

  const typename Kernel::Triangle_3& triangle() const { return m_triangle; }

  // Inserts a point, or a segment.
  // \pre the points are in the triangle
  void insert(const Point& p) { m_triangulation.insert(project(p)); }
  void insert(const Point& p, const Point& q) {
    m_triangulation.insert_constraint(project(p), project(q));
  }

  // Calls `visit` with the rounded corners of each triangle, oriented like the original triangle.
  template <class Visit> void visit_triangles(const Visit& visit) {
    const auto plane = m_triangle.supporting_plane();
    for (const auto v : m_triangulation.finite_vertex_handles())
      if (v->index() == unknown) {
        v->index() = int(m_points.size());
        m_points.push_back(lift(v->point(), plane));
      }
    for (const auto f : m_triangulation.finite_face_handles()) {
      std::array<Coordinates_3, 3> corners;
      for (int i = 0; i < 3; ++i)
        corners[i] = m_points[f->vertex(i)->index()];
      if (!m_is_counterclockwise)
        std::swap(corners[1], corners[2]);
      visit(corners);
    }
  }

private:
  static constexpr int unknown = -1;

  // A vertex that stores the index of its rounded point.
  template <class Base> class Vertex_of_split : public Base
  {
  public:
    using Base::Base;
    template <class Tds> struct Rebind_TDS
    {
      using Other = Vertex_of_split<typename Base::template Rebind_TDS<Tds>::Other>;
    };
    int& index() { return m_index; }

  private:
    int m_index = unknown;
  };

  using Traits = Nearly_delaunay_traits_2<Kernel>;
  using Vertex = Vertex_of_split<Triangulation_vertex_base_2<Traits>>;
  using Face = Constrained_triangulation_face_base_2<Traits>;
  // The triangulation of the constraints. Intersections of segments are computed from the segments
  // as they were inserted.
  using Triangulation = Constrained_triangulation_plus_2<Constrained_Delaunay_triangulation_2<
      Traits, Triangulation_data_structure_2<Vertex, Face>, Exact_intersections_tag>>;

  Point exact_corner(std::size_t i) const {
    return {m_points[i][0], m_points[i][1], m_points[i][2]};
  }

  typename Kernel::Point_2 project(const Point& p) const {
    return {p[(m_axis + 1) % 3], p[(m_axis + 2) % 3]};
  }

  // Returns the axis of projection: the axis nearest to the normal that is not parallel to the
  // triangle.
  int axis_of_projection() {
    const auto &a = m_points[0], &b = m_points[1], &c = m_points[2];
    std::array<int, 3> axes = {0, 1, 2};
    std::array<double, 3> normal;
    for (int k : axes) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      normal[k] = std::abs((b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]));
    }
    std::stable_sort(axes.begin(), axes.end(), [&](int k, int l) { return normal[k] > normal[l]; });
    for (int k : axes) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      using Point_2 = Predicates_kernel::Point_2;
      const Orientation o =
          orientation(Point_2(a[i], a[j]), Point_2(b[i], b[j]), Point_2(c[i], c[j]));
      if (o == COLLINEAR)
        continue;
      m_is_counterclockwise = o == LEFT_TURN;
      return k;
    }
    return axes[0]; // a degenerate triangle, which is never split
  }

  // Returns the rounded point of the triangle. Equal points get equal coordinates in all triangles.
  Coordinates_3 lift(const typename Kernel::Point_2& p,
                     const typename Kernel::Plane_3& plane) const {
    const std::array<typename Kernel::FT, 3> normal = {plane.a(), plane.b(), plane.c()};
    const int i = (m_axis + 1) % 3, j = (m_axis + 2) % 3;
    const typename Kernel::FT x = p.x(), y = p.y();
    const typename Kernel::FT z = -(normal[i] * x + normal[j] * y + plane.d()) / normal[m_axis];
    Coordinates_3 result;
    result[i] = to_double(exact(x));
    result[j] = to_double(exact(y));
    result[m_axis] = to_double(exact(z));
    return result;
  }

  std::vector<Coordinates_3> m_points; // the corners first
  bool m_is_counterclockwise = true;   // orientation of the projection
  int m_axis;
  typename Kernel::Triangle_3 m_triangle;
  Triangulation m_triangulation;
};

// Inserts the intersection of two triangles into both of them.
template <class Kernel>
void insert_intersection(Split_triangle_3<Kernel>& s, Split_triangle_3<Kernel>& t) {
  const auto common = intersection(s.triangle(), t.triangle());
  if (!common)
    return;
  const auto insert_polygon = [&](const auto& points, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) {
      s.insert(points[i], points[(i + 1) % size]);
      t.insert(points[i], points[(i + 1) % size]);
    }
  };
  if (const auto* point = get_alternative<typename Kernel::Point_3>(*common)) {
    s.insert(*point);
    t.insert(*point);
  } else if (const auto* segment = get_alternative<typename Kernel::Segment_3>(*common)) {
    s.insert(segment->source(), segment->target());
    t.insert(segment->source(), segment->target());
  } else if (const auto* triangle = get_alternative<typename Kernel::Triangle_3>(*common)) {
    insert_polygon(*triangle, 3);
  } else if (const auto* polygon =
                 get_alternative<std::vector<typename Kernel::Point_3>>(*common)) {
    insert_polygon(*polygon, polygon->size());
  }
}

inline bool have_same_corners(const Triangle_indices& a, const Triangle_indices& b) {
  return sorted(a) == sorted(b);
}

// Merges equal points and removes degenerate triangles.
template <class Kernel> void tidy_up(Split_soup_3& soup) {
  static_cast<Triangle_soup_3&>(soup) = merge_points(soup);
  std::vector<char> has_area;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    has_area.push_back(!exact_triangle(soup, t).is_degenerate());
  keep(soup, has_area);
}

// Splits the triangles of the pairs.
// \pre the pairs are distinct
template <class Kernel>
Split_soup_3 split_pairs(const Split_soup_3& soup,
                         const std::vector<std::pair<std::size_t, std::size_t>>& pairs) {
  std::map<std::size_t, Split_triangle_3<Kernel>> splits;
  const auto split = [&](std::size_t t) -> Split_triangle_3<Kernel>& {
    const auto found = splits.find(t);
    if (found != splits.end())
      return found->second;
    const auto& [a, b, c] = soup.triangles[t];
    const std::array<Coordinates_3, 3> corners = {soup.points[a], soup.points[b], soup.points[c]};
    return splits.emplace(t, corners).first->second;
  };
  for (const auto& [s, t] : pairs) {
    Progress_scope::check();
    insert_intersection(split(s), split(t));
  }
  Split_soup_3 result;
  result.points = soup.points;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    Progress_scope::check();
    const auto found = splits.find(t);
    if (found == splits.end()) {
      result.triangles.push_back(soup.triangles[t]);
      result.origins.push_back(soup.origins[t]);
      continue;
    }
    found->second.visit_triangles([&](const std::array<Coordinates_3, 3>& corners) {
      const std::size_t i = result.points.size();
      result.points.insert(result.points.end(), corners.begin(), corners.end());
      result.triangles.push_back({i, i + 1, i + 2});
      result.origins.push_back(soup.origins[t]);
    });
    splits.erase(found);
  }
  return result;
}

// Returns the pairs of intersecting triangles that do not have the same corners.
inline std::vector<std::pair<std::size_t, std::size_t>> pairs_to_split(const Split_soup_3& soup) {
  auto pairs = crossing_triangles(soup);
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(),
                             [&soup](const auto& pair) {
                               return have_same_corners(soup.triangles[pair.first],
                                                        soup.triangles[pair.second]);
                             }),
              pairs.end());
  return pairs;
}

// Splits triangles where they intersect. In the result, triangles meet in common vertices and edges
// only, or have the same three corners. Intersection points are computed exactly and then rounded.
// Rounding may create new intersections, so the splitting is repeated. Degenerate triangles are
// removed. A soup without intersections is returned bitwise unchanged unless `join()` changes it.
//
// Needles between points that only rounding separates would intersect many triangles. Therefore,
// `join(soup, round)` joins near features before each round, and returns whether to go on.
//
// Returns `nullopt` if `join()` stops, if the number of intersections increases twice in
// succession, or if triangles still intersect after the maximum number of repetitions.
template <class Kernel = Exact_predicates_exact_constructions_kernel>
std::optional<Split_soup_3>
split_at_crossings(const Triangle_soup_3& input,
                   const std::function<bool(Split_soup_3&, int)>& join) {
  static constexpr int most_rounds = 30; // two or three are usual
  static constexpr int most_increases = 1;
  Split_soup_3 soup = undivided(input);
  std::size_t number = std::size_t(-1); // of intersections
  int increases = 0;
  for (int round = 0; round < most_rounds && increases <= most_increases; ++round) {
    if (!join(soup, round))
      return std::nullopt;
    tidy_up<Kernel>(soup);
    const auto pairs = pairs_to_split(soup);
    if (pairs.empty())
      return soup;
    increases = pairs.size() > number ? increases + 1 : 0;
    number = pairs.size();
    soup = split_pairs<Kernel>(soup, pairs);
  }
  return std::nullopt;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_ARRANGEMENT_SPLIT_AT_CROSSINGS_3_H
