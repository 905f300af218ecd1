// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_SUBDIVIDE_INTERFACE_3_H
#define CGAL_INTERFACE_REMESHING_SUBDIVIDE_INTERFACE_3_H

#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Interface_remeshing/extract_interface_3.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/internal/sets/Signed_union_find.h>
#include <CGAL/Mesh_support/internal/threads/stoppable_sort.h>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// A step of Loop's subdivision scheme on an interface, which need not be manifold. The interface is
// cut into patches along the curves where sheets meet or end. The new position of a point on a
// curve depends on the curve only, and is thus the same for all incident patches. Unlike CGAL's
// subdivision, the step can be interrupted.
template <class Surface> class Loop_subdivider_3
{
  using Point = typename Surface::Point_3;
  using Vertex_handle = typename Surface::Vertex_handle;
  using Pair = std::array<std::size_t, 2>;
  static constexpr std::size_t none = std::size_t(-1);

public:
  explicit Loop_subdivider_3(const Surface& surface)
      : m_surface(surface), m_edge(3 * surface.triangles.size()),
        m_fan(3 * surface.triangles.size()) {
    find_edges();
    find_ends();
    sum_up_around();
  }

  // Returns the subdivided surface. Triangle t becomes the triangles 4 t to 4 t + 3. The points of
  // edges follow the existing points.
  Surface subdivided() const {
    const std::size_t n = m_surface.points.size();
    Surface result;
    result.points = moved_points();
    result.vertices = m_surface.vertices;
    result.boundary_classes = m_surface.boundary_classes;
    for (const Edge& edge : m_edges) {
      Progress_scope::check();
      result.points.push_back(point_on(edge));
      result.vertices.push_back(Vertex_handle());
      result.boundary_classes.push_back(boundary_class(edge));
    }
    result.triangles.reserve(4 * m_surface.triangles.size());
    result.labels.reserve(4 * m_surface.triangles.size());
    for (std::size_t t = 0; t < m_surface.triangles.size(); ++t) {
      Progress_scope::check();
      const auto [a, b, c] = m_surface.triangles[t];
      const std::size_t ab = n + m_edge[3 * t], bc = n + m_edge[3 * t + 1],
                        ca = n + m_edge[3 * t + 2];
      for (const auto& child : {std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c},
                                std::array{ab, bc, ca}}) {
        result.triangles.push_back(child);
        result.labels.push_back(m_surface.labels[t]);
      }
    }
    return result;
  }

private:
  struct Edge
  {
    Pair points;             // the smaller index first
    std::size_t side, other; // the first and the last side on the edge
    bool is_border;          // incident to a single triangle
    bool is_smooth;          // exactly two triangles, oriented and labeled alike
  };
  struct Sum
  {
    double x = 0, y = 0, z = 0;
    std::size_t number = 0; // number of points in the sum

    void add(const Point& p) {
      x += p.x();
      y += p.y();
      z += p.z();
      ++number;
    }
  };

  // Triangle t has the corners 3 t + k, with k = 0, 1, 2. A corner is also the index of the side
  // from this corner to the next one.
  static std::size_t next(std::size_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
  const std::size_t& point(std::size_t corner) const {
    return m_surface.triangles[corner / 3][corner % 3];
  }
  const Point& opposite(std::size_t side) const {
    return m_surface.points[point(next(next(side)))];
  }

  // Finds the edges, ordered by their points, and the fans. A fan is a set of corners at a point
  // that are connected by smooth edges.
  void find_edges() {
    std::vector<std::pair<Pair, std::size_t>> sides;
    sides.reserve(m_edge.size());
    for (std::size_t side = 0; side < m_edge.size(); ++side) {
      Progress_scope::check();
      const auto [p, q] = std::minmax(point(side), point(next(side)));
      sides.push_back({{p, q}, side});
    }
    stoppable_sort(sides.begin(), sides.end());
    Signed_union_find fans(m_fan.size());
    for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
      Progress_scope::check();
      while (last < sides.size() && sides[last].first == sides[first].first)
        m_edge[sides[last++].second] = m_edges.size();
      const std::size_t side = sides[first].second, other = sides[last - 1].second;
      const bool is_smooth = last - first == 2 && point(side) != point(other) &&
                             m_surface.labels[side / 3] == m_surface.labels[other / 3];
      m_edges.push_back({sides[first].first, side, other, last - first == 1, is_smooth});
      if (is_smooth) {
        fans.unite(side, next(other), false);
        fans.unite(next(side), other, false);
      }
    }
    for (std::size_t corner = 0; corner < m_fan.size(); ++corner) {
      Progress_scope::check();
      const std::size_t first = fans.find(corner).first; // the first corner of the fan
      m_fan[corner] = first == corner ? m_corner_of_fan.size() : m_fan[first];
      if (first == corner)
        m_corner_of_fan.push_back(corner);
    }
  }

  // Finds the other points of the two curve edges at which a fan ends; `none` for a closed fan.
  void find_ends() {
    m_ends.assign(m_corner_of_fan.size(), {none, none});
    const auto add = [&](std::size_t corner, std::size_t p) {
      Pair& ends = m_ends[m_fan[corner]];
      ends = {(std::min)(ends[0], p), ends[0] == none ? none : (std::max)(ends[0], p)};
    };
    for (std::size_t side = 0; side < m_edge.size(); ++side)
      if (!m_edges[m_edge[side]].is_smooth) {
        add(side, point(next(side)));
        add(next(side), point(side));
      }
  }

  // Computes the sums of the points that follow the center of each fan. For a closed fan, these are
  // all points around the center.
  void sum_up_around() {
    m_around.resize(m_corner_of_fan.size());
    for (std::size_t corner = 0; corner < m_fan.size(); ++corner) {
      Progress_scope::check();
      m_around[m_fan[corner]].add(m_surface.points[point(next(corner))]);
    }
  }

  // Returns the new position of the point of a closed fan, by Loop's rule.
  Point moved_point(std::size_t fan) const {
    const Point& p = m_surface.points[point(m_corner_of_fan[fan])];
    const Sum& around = m_around[fan];
    const double n = double(around.number), c = 3. / 8 + std::cos(2 * CGAL_PI / n) / 4,
                 all = 5. / 8 - c * c, own = 1 - all, each = all / n;
    return Point(own * p.x() + each * around.x, own * p.y() + each * around.y,
                 own * p.z() + each * around.z);
  }

  Point point_on(const Edge& edge) const {
    const Point &a = m_surface.points[edge.points[0]], &b = m_surface.points[edge.points[1]];
    if (!edge.is_smooth)
      return midpoint(a, b);
    const Point &c = opposite(edge.side), &d = opposite(edge.other);
    return Point((3 * (a.x() + b.x()) + c.x() + d.x()) / 8,
                 (3 * (a.y() + b.y()) + c.y() + d.y()) / 8,
                 (3 * (a.z() + b.z()) + c.z() + d.z()) / 8);
  }

  // Returns the boundary class of the new point of an edge. An edge between two boundary points is
  // on the boundary only if the interface ends there. Otherwise it may cross the interior of the
  // domain.
  Boundary_class::Bits boundary_class(const Edge& edge) const {
    const auto& classes = m_surface.boundary_classes;
    return edge.is_border ? classes[edge.points[0]] & classes[edge.points[1]]
                          : Boundary_class::inside;
  }

  // Returns whether a point is fixed by the boundary. Points in the interior of a side of a box
  // follow their curve. Points on edges of the box, and on the boundary of other domains, are
  // fixed.
  bool is_constrained_by_boundary(std::size_t p) const {
    const Boundary_class::Bits sides = m_surface.boundary_classes[p];
    return sides == Boundary_class::fixed || (sides & (sides - 1)) != 0;
  }

  // Returns the new positions of the existing points. A point moves along a curve only if all fans
  // at the point end with the same two edges. Points where curves branch or end, or where sheets
  // touch in a single point, stay.
  std::vector<Point> moved_points() const {
    std::vector<Point> points = m_surface.points;
    std::vector<std::size_t> fan(points.size(), none); // the first fan at each point
    std::vector<char> stays(points.size(), false);
    for (std::size_t f = 0; f < m_corner_of_fan.size(); ++f) {
      const std::size_t p = point(m_corner_of_fan[f]);
      const bool is_first = fan[p] == none, is_closed = m_ends[f][0] == none;
      if (is_first)
        fan[p] = f;
      if (is_closed ? !is_first : m_ends[f][0] == m_ends[f][1] || m_ends[f] != m_ends[fan[p]])
        stays[p] = true;
    }
    for (std::size_t p = 0; p < points.size(); ++p) {
      Progress_scope::check();
      if (fan[p] == none || stays[p] || is_constrained_by_boundary(p))
        continue;
      const auto [a, b] = m_ends[fan[p]];
      if (a == none)
        points[p] = moved_point(fan[p]);
      else
        points[p] = along_curve(m_surface.points[a], m_surface.points[p], m_surface.points[b]);
    }
    return points;
  }

  // Returns the new position of p by Loop's boundary rule. The result is bitwise independent of the
  // order of a and b.
  static Point along_curve(const Point& a, const Point& p, const Point& b) {
    return Point((a.x() + b.x() + 6 * p.x()) / 8, (a.y() + b.y() + 6 * p.y()) / 8,
                 (a.z() + b.z() + 6 * p.z()) / 8);
  }

  const Surface& m_surface;
  std::vector<Edge> m_edges;
  std::vector<std::size_t> m_edge; // edge of each side
  std::vector<std::size_t> m_fan;  // fan of each corner
  std::vector<std::size_t> m_corner_of_fan;
  std::vector<Pair> m_ends;  // ends of each fan
  std::vector<Sum> m_around; // sums of points of each fan
};

} // namespace internal

/*!
\ingroup PkgInterfaceRemeshingRef

Subdivides an interface with Loop's scheme, for rendering (C. Loop, <em>Smooth subdivision surfaces
based on triangles</em>, Master's thesis, University of Utah, 1987). In each subdivision, a triangle
is divided into four, and points move towards a smooth surface. n log n in the size of the result,
which is multiplied by four in each subdivision.

An edge is on a curve if it has one triangle or more than two, or if the labels change at it. On the
manifold patches between curves, points are those of `Subdivision_method_3::Loop_subdivision()`, up
to rounding. Curves are subdivided by the rule for borders, 1/8, 3/4, 1/8. Each curve is subdivided
once for all patches that meet there, so that the patches still share its points. Some points do not
move:

- points where curves branch or end, as in quadruple points, and points where sheets touch in a
  single point;
- points on the edges of a box, so that the interface still ends in the sides of the box;
- original vertices on the boundary of a domain that is not a box.

The interface between two labels, extracted alone, has a border where other labels meet it. Its
subdivision agrees with the corresponding part of the whole interface if no curve branches on it. On
a torus, a component that was cut open has a border at the cut.

\tparam Complex an instance of `Deformable_simplicial_complex_3`

\param surface a result of `extract_interface()` or of this function
\param number_of_subdivisions number of subdivisions, at least 0; with 0, the surface is unchanged
\return the subdivided surface. In each subdivision, triangle i becomes the triangles 4 i to 4 i + 3
        with its labels and its orientation; the last one is in the middle. New points are on edges.
        They follow the old points, ordered by the indices of the ends of their edges. In
        `vertices`, new points have a default-constructed handle, and old points keep their vertex.

\throws Error if `number_of_subdivisions` is negative
\throws Interrupted_error if the callback of a `Progress_scope` returns `false`

\sa `extract_interface()`
*/
template <class Complex>
Interface_surface_3<Complex> subdivide_interface(Interface_surface_3<Complex> surface,
                                                 int number_of_subdivisions = 1) {
  if (number_of_subdivisions < 0)
    throw Error("the number of subdivisions is negative: use 0 or "
                "more");
  for (int i = 0; i < number_of_subdivisions; ++i)
    surface = internal::Loop_subdivider_3<Interface_surface_3<Complex>>(surface).subdivided();
  return surface;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_SUBDIVIDE_INTERFACE_3_H
