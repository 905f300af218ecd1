// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_CLOUDS_CLOUD_SIDES_3_H
#define CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_CLOUDS_CLOUD_SIDES_3_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/internal/sets/Signed_union_find.h>
#include <CGAL/Mesh_support/internal/threads/stoppable_sort.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/Point_cloud_3.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/number_utils.h>
#include <CGAL/spatial_sort.h>

#include <array>
#include <cstdint>
#include <iterator>
#include <limits>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The two sides of the surface that a cloud samples. The poles of a point are its largest empty
// balls. They are on different sides. Balls that overlap deeply are on the same side. These
// relations are processed in the order of their certainty. A relation that contradicts previous
// ones is ignored. The method follows R. Kolluri, J. R. Shewchuk and J. F. O'Brien, "Spectral
// surface reconstruction from noisy point clouds", SGP 2004, with a spanning forest in place of
// their eigenvectors. Relations depend on angles only. A hole of the cloud is therefore closed if
// it is narrow compared with the solid behind it.
//
// The time is n log n in the number n of points, if their Delaunay triangulation has linear size.
class Cloud_sides_3
{
  using Kernel = Exact_predicates_inexact_constructions_kernel;

public:
  using Point = Kernel::Point_3;
  using Vector = Kernel::Vector_3;

  struct Ball // the empty circumscribed ball of a cell
  {
    Point center;
    double squared_radius = 0; // 0 for cells that are flat in double precision
  };

  // A Delaunay facet between the inside and the outside.
  struct Boundary_facet
  {
    std::array<Point, 3> points;
    double reach; // largest reach of the points; infinite at outliers
  };

  // A ball whose side is certain: it is a pole of a point whose poles are on different sides, in
  // directions that differ by more than 120 degrees.
  struct Certain_ball
  {
    Ball ball;
    double reach; // as for a facet
    bool is_inside;
  };

  template <class Points>
  explicit Cloud_sides_3(const Points& points)
      : m_outward(points.size(), NULL_VECTOR),
        m_room(points.size(), std::numeric_limits<double>::infinity()) {
    triangulate(points);
    const std::vector<Ball> balls = this->balls();
    const std::vector<Poles> poles = this->poles(balls);
    Signed_union_find sides(balls.size());
    join_outside(sides);
    join_by(relations_of_poles(balls, poles), sides);
    join_by(relations_of_neighbors(balls), sides);
    for (std::size_t c = 0; c < balls.size(); ++c)
      m_is_inside.push_back(sides.find(c).second != sides.find(outside).second);
    m_is_certain.assign(balls.size(), 0);
    for (std::size_t i = 0; i < poles.size(); ++i)
      if (has_both(poles[i]) && m_is_inside[poles[i][0]] != m_is_inside[poles[i][1]]) {
        const bool is_first_inside = m_is_inside[poles[i][0]] != 0;
        const Ball &inner = balls[poles[i][is_first_inside ? 0 : 1]],
                   &outer = balls[poles[i][is_first_inside ? 1 : 0]];
        m_outward[i] = outer.center - inner.center;
        m_room[i] = std::sqrt(outer.squared_radius);
        if (angle_of_poles(m_vertices[i]->point(), inner, outer) < CGAL_PI / 3)
          m_is_certain[poles[i][0]] = m_is_certain[poles[i][1]] = 1;
      }
  }

  // Returns whether p is inside. The search walks from the cloud point `near`. On the boundary of
  // cells, p is inside if all these cells are inside.
  bool is_inside(const Point& p, std::size_t nearby) const {
    typename Delaunay::Locate_type type;
    int i, j;
    const Cell_handle c = m_delaunay.locate(p, type, i, j, m_vertices[nearby]);
    if (type == Delaunay::VERTEX)
      return is_inside_around(c->vertex(i));
    if (type == Delaunay::FACET)
      return is_inside(c) && is_inside(c->neighbor(i));
    if (type != Delaunay::EDGE)
      return is_inside(c);
    auto around = m_delaunay.incident_cells(c, i, j);
    const auto first = around;
    do
      if (!is_inside(Cell_handle(around)))
        return false;
    while (++around != first);
    return true;
  }
  bool encloses_anything() const {
    return std::find(m_is_inside.begin(), m_is_inside.end(), 1) != m_is_inside.end();
  }
  // Returns an approximate outward normal of a point, of any length. It is null if both poles are
  // on the same side.
  const Vector& outward(std::size_t i) const { return m_outward[i]; }
  // Returns the radius of the largest empty ball that touches a point from outside; infinite if
  // unknown.
  double room(std::size_t i) const { return m_room[i]; }

  // Returns the boundary of the inside. `reaches` belong to the points that are kept.
  template <class Reaches> std::vector<Boundary_facet> boundary(const Reaches& reaches) const {
    std::vector<Boundary_facet> result;
    for (const auto& f : m_delaunay.finite_facets()) {
      Progress_scope::check();
      if (is_inside(f.first) == is_inside(f.first->neighbor(f.second)))
        continue;
      Boundary_facet facet{{}, 0};
      for (int k = 0; k < 3; ++k) {
        const Vertex_handle v = f.first->vertex((f.second + 1 + k) % 4);
        facet.points[std::size_t(k)] = v->point();
        facet.reach = (std::max)(facet.reach, reach_of(v, reaches));
      }
      result.push_back(facet);
    }
    return result;
  }

  // Returns the balls whose sides are certain.
  template <class Reaches> std::vector<Certain_ball> certain_balls(const Reaches& reaches) const {
    std::vector<Certain_ball> result;
    for (auto c : m_delaunay.finite_cell_handles()) {
      Progress_scope::check();
      if (m_is_certain[c->info()] == 0)
        continue;
      Certain_ball ball{ball_of(c), 0, is_inside(c)};
      for (int k = 0; k < 4; ++k)
        ball.reach = (std::max)(ball.reach, reach_of(c->vertex(k), reaches));
      result.push_back(ball);
    }
    return result;
  }

  void keep(const std::vector<char>& is_kept) {
    std::size_t number = 0;
    for (std::size_t i = 0; i < m_vertices.size(); ++i)
      m_vertices[i]->info() = is_kept[i] != 0 ? number++ : left_out;
    keep_marked(m_outward, is_kept);
    keep_marked(m_room, is_kept);
    keep_marked(m_vertices, is_kept);
  }

private:
  using Ball_index = std::uint32_t;
  using Vertex_base = Triangulation_vertex_base_with_info_3<std::size_t, Kernel>;
  using Cell_base = Triangulation_cell_base_with_info_3<Ball_index, Kernel,
                                                        Delaunay_triangulation_cell_base_3<Kernel>>;
  using Delaunay =
      Delaunay_triangulation_3<Kernel, Triangulation_data_structure_3<Vertex_base, Cell_base>>;
  using Vertex_handle = Delaunay::Vertex_handle;
  using Cell_handle = Delaunay::Cell_handle;
  using Poles = std::array<Ball_index, 2>;
  static constexpr Ball_index outside = 0, none = static_cast<Ball_index>(-1);
  static constexpr std::size_t box_corner = static_cast<std::size_t>(-1),
                               left_out = static_cast<std::size_t>(-2);

  struct Relation
  {
    float angle; // uncertainty: 0 is certain
    Ball_index first, second;
    bool are_opposite;

    bool operator<(const Relation& r) const {
      return std::tie(angle, first, second, are_opposite) <
             std::tie(r.angle, r.first, r.second, r.are_opposite);
    }
  };

  static double angle(double cosine) { return std::acos((std::max)(-1., (std::min)(1., cosine))); }
  // Returns the angle at which two spheres meet: 0 if they are equal, pi if they touch from
  // outside.
  static double angle(const Ball& a, const Ball& b) {
    if (!(a.squared_radius > 0) || !(b.squared_radius > 0))
      return CGAL_PI / 2; // no information
    return angle((a.squared_radius + b.squared_radius - squared_distance(a.center, b.center)) /
                 (2 * std::sqrt(a.squared_radius * b.squared_radius)));
  }
  // Returns the angle by which the directions to two poles differ from opposite directions.
  static double angle_of_poles(const Point& p, const Ball& a, const Ball& b) {
    const Vector v = a.center - p, w = b.center - p;
    return angle(-(v * w) / std::sqrt(v.squared_length() * w.squared_length()));
  }
  // Returns the reach of a vertex: infinite at outliers, 0 at the corners of the box.
  template <class Reaches> double reach_of(Vertex_handle v, const Reaches& reaches) const {
    if (is_of_box(v))
      return 0;
    return v->info() == left_out ? std::numeric_limits<double>::infinity() : reaches[v->info()];
  }
  static bool has_both(const Poles& p) { return p[0] != none && p[1] != none; }
  bool is_of_box(Vertex_handle v) const { return v->info() == box_corner; }
  bool is_inside(Cell_handle c) const { return m_is_inside[c->info()] != 0; }
  bool is_inside_around(Vertex_handle v) const {
    std::vector<Cell_handle> star;
    m_delaunay.incident_cells_threadsafe(v, std::back_inserter(star));
    return std::all_of(star.begin(), star.end(), [&](Cell_handle c) { return is_inside(c); });
  }

  // Triangulates the points and the corners of a box around them. The outside begins at the box.
  template <class Points> void triangulate(const Points& points) {
    static constexpr double away = 2; // in extents of the cloud
    Bbox_3 box;
    std::vector<std::pair<Point, std::size_t>> vertices; // with their indices
    for (const auto& p : points) {
      vertices.emplace_back(Point(p.x(), p.y(), p.z()), vertices.size());
      box += p.bbox();
    }
    const double margin = away * (std::max)({box.xmax() - box.xmin(), box.ymax() - box.ymin(),
                                             box.zmax() - box.zmin()});
    for (double x : {box.xmin() - margin, box.xmax() + margin})
      for (double y : {box.ymin() - margin, box.ymax() + margin})
        for (double z : {box.zmin() - margin, box.zmax() + margin})
          vertices.emplace_back(Point(x, y, z), box_corner);
    using By_point =
        Spatial_sort_traits_adapter_3<Kernel,
                                      First_of_pair_property_map<std::pair<Point, std::size_t>>>;
    spatial_sort(vertices.begin(), vertices.end(), By_point());
    m_vertices.resize(points.size());
    Vertex_handle last;
    for (const auto& [point, index] : vertices) {
      Progress_scope::check();
      last = m_delaunay.insert(point, last);
      last->info() = index;
      if (index != box_corner)
        m_vertices[index] = last;
    }
  }

  // Returns the balls of the finite cells, numbered from 1.
  std::vector<Ball> balls() {
    std::vector<Ball> result(1);
    for (auto c : m_delaunay.all_cell_handles()) {
      Progress_scope::check();
      c->info() = outside;
      if (m_delaunay.is_infinite(c))
        continue;
      c->info() = Ball_index(result.size());
      result.push_back(ball_of(c));
    }
    return result;
  }

  static Ball ball_of(Cell_handle cell) {
    const Point& p = cell->vertex(0)->point();
    const Vector a = cell->vertex(1)->point() - p, b = cell->vertex(2)->point() - p,
                 c = cell->vertex(3)->point() - p;
    static constexpr double flat = 1e-12; // of the volume of a cube: rounding errors
    const Vector across = cross_product(b, c);
    const double volume = a * across;
    const bool is_flat = volume * volume <=
                         flat * flat * a.squared_length() * b.squared_length() * c.squared_length();
    const Vector to_center =
        (a.squared_length() * across + b.squared_length() * cross_product(c, a) +
         c.squared_length() * cross_product(a, b)) /
        (2 * volume);
    const double squared = to_center.squared_length();
    return is_flat || !std::isfinite(squared) ? Ball{p, 0} : Ball{p + to_center, squared};
  }

  void join_outside(Signed_union_find& sides) const {
    for (auto c : m_delaunay.finite_cell_handles())
      for (int k = 0; k < 4; ++k)
        if (is_of_box(c->vertex(k)))
          sides.unite(outside, c->info(), false);
  }

  // Returns the poles of each point: its largest ball, and its largest ball in the opposite half
  // space.
  std::vector<Poles> poles(const std::vector<Ball>& balls) const {
    std::vector<Poles> result(m_outward.size(), Poles{none, none});
    std::vector<Cell_handle> star;
    for (auto v : m_delaunay.finite_vertex_handles()) {
      if (is_of_box(v))
        continue;
      Progress_scope::check();
      star.clear();
      m_delaunay.incident_cells(v, std::back_inserter(star)); // all finite, within the box
      Vector across(0, 0, 0);
      for (Ball_index& pole : result[v->info()]) {
        double largest = 0;
        for (Cell_handle c : star) {
          const Ball& ball = balls[c->info()];
          if (ball.squared_radius > largest && (ball.center - v->point()) * across <= 0) {
            largest = ball.squared_radius;
            pole = c->info();
          }
        }
        if (pole != none)
          across = balls[pole].center - v->point();
      }
    }
    return result;
  }

  std::vector<Relation> relations_of_poles(const std::vector<Ball>& balls,
                                           const std::vector<Poles>& poles) const {
    std::vector<Relation> result;
    for (auto v : m_delaunay.finite_vertex_handles())
      if (!is_of_box(v) && has_both(poles[v->info()])) {
        const Poles& p = poles[v->info()];
        result.push_back(
            {float(angle_of_poles(v->point(), balls[p[0]], balls[p[1]])), p[0], p[1], true});
      }
    for (const auto& e : m_delaunay.finite_edges()) {
      Progress_scope::check();
      const auto v = e.first->vertex(e.second), w = e.first->vertex(e.third);
      if (is_of_box(v) || is_of_box(w))
        continue;
      for (Ball_index a : poles[v->info()])
        for (Ball_index b : poles[w->info()])
          if (a != none && b != none && a != b)
            add_if_deep(balls, a, b, result);
    }
    return result;
  }

  // Returns relations of all neighboring cells. They determine the sides of cells that are no
  // poles.
  std::vector<Relation> relations_of_neighbors(const std::vector<Ball>& balls) const {
    std::vector<Relation> result;
    for (const auto& f : m_delaunay.finite_facets()) {
      Progress_scope::check();
      const Ball_index a = f.first->info(), b = f.first->neighbor(f.second)->info();
      if (a != outside && b != outside)
        result.push_back(
            {float(angle(balls[a], balls[b])), (std::min)(a, b), (std::max)(a, b), false});
    }
    return result;
  }

  static void add_if_deep(const std::vector<Ball>& balls, Ball_index a, Ball_index b,
                          std::vector<Relation>& result) {
    const double d = angle(balls[a], balls[b]);
    if (d < CGAL_PI / 2)
      result.push_back({float(d), (std::min)(a, b), (std::max)(a, b), false});
  }

  static void join_by(std::vector<Relation> relations, Signed_union_find& sides) {
    stoppable_sort(relations.begin(), relations.end());
    for (const Relation& r : relations) {
      Progress_scope::check();
      sides.unite(r.first, r.second, r.are_opposite);
    }
  }

  Delaunay m_delaunay;
  std::vector<Vertex_handle> m_vertices; // one for each point
  std::vector<char> m_is_inside;         // one for each ball
  std::vector<char> m_is_certain;        // for each ball, whether its side is certain
  std::vector<Vector> m_outward;
  std::vector<double> m_room;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_CLOUDS_CLOUD_SIDES_3_H
