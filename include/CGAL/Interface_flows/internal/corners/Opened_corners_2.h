// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_FLOWS_INTERNAL_CORNERS_OPENED_CORNERS_2_H
#define CGAL_INTERFACE_FLOWS_INTERNAL_CORNERS_OPENED_CORNERS_2_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>
#include <CGAL/Interface_remeshing/refine_cells.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The corners of curves from which a front moves away. By Huygens' principle, the front of such a
// corner is an arc around it. The class inserts vertices into the segments at these corners and
// returns their destinations on the arcs. The segments of an arc are tangents of the circle, so
// their normals and a mitered motion of the next steps keep the arc.
template <class Complex> class Opened_corners_2
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Point = typename Complex::Point;
  using Vector = typename Complex::Vector;

  // Inserts the vertices. A corner gets fewer vertices if the segments of its arc would be too
  // short, and none if it turns only little, or more than two segments meet there.
  // \param interface_ the interface of the complex as it is
  // \param speed of the front, positive if labeled phases grow
  // \param dt length of the step
  // \param sharpest angle between the normals of corners that stay sharp, in radians
  // \param finest largest angle between neighboring segments of an arc
  Opened_corners_2(Complex& complex, const Interface_snapshot<Complex>& interface_, double speed,
                   double dt, double sharpest, double finest, Deformation_visitor<Complex>& visitor)
      : m_complex(complex), m_cavity(complex), m_visitor(visitor), m_sharpest(sharpest),
        m_finest(finest) {
    const double distance = speed * dt;
    if (distance == 0 || !std::isfinite(distance))
      return;
    std::vector<Arc> arcs;
    for (const Corner& corner : corners(interface_, distance > 0 ? 1 : -1))
      if (const Arc arc = arc_of(corner, std::abs(distance)); arc.number > 0)
        arcs.push_back(arc);
    for (const Arc& arc : arcs)
      m_report.split += refine_around(complex, arc.corner.vertex, coarsest * arc.chord, visitor);
    for (const Arc& arc : arcs)
      open(arc, std::abs(distance));
    std::sort(m_on_arcs.begin(), m_on_arcs.end(),
              [](const On_arc& a, const On_arc& b) { return a.time_stamp < b.time_stamp; });
  }

  // Returns the number of inserted vertices.
  std::size_t inserted() const { return m_report.split; }

  // Replaces the destinations of the vertices on arcs.
  void place(const Interface_snapshot<Complex>& interface_,
             std::vector<Point>& destinations) const {
    auto next = m_on_arcs.begin(); // both lists are in the order of time stamps
    for (std::size_t i = 0; i < destinations.size(); ++i) {
      const std::size_t time_stamp = interface_.vertices[i]->time_stamp();
      while (next != m_on_arcs.end() && next->time_stamp < time_stamp)
        ++next;
      if (next != m_on_arcs.end() && next->time_stamp == time_stamp)
        destinations[i] = next->destination;
    }
  }

private:
  struct Corner
  {
    Vertex_handle vertex;
    std::array<Vector, 2> edges;   // to the neighbors
    std::array<Vector, 2> normals; // unit vectors in the direction of the motion
    double angle;                  // between the normals
  };

  struct Arc
  {
    Corner corner;
    int number;    // of vertices, at least 2; 0 if the corner stays sharp
    double radius; // before the motion
    double chord;  // after the motion
  };

  struct On_arc
  {
    std::size_t time_stamp; // of the vertex
    Point destination;
  };

  // Shortest segment of an arc, relative to the mean edge. A corner becomes round at once, even if
  // the step is much shorter. The area that is cut off is less than .0001 squared edges.
  static constexpr double shortest = .01;
  // Rounding of angles. The next step must not open the corners of an arc again.
  static constexpr double rounding = 1e-6;
  // Longest edge at a corner, in segments of the arc.
  static constexpr double coarsest = 8;
  // Part of a segment that the arc of one end can take.
  static constexpr double part_of_segment = .4;

  // Lists the corners from which the front moves away, in the order of their vertices.
  std::vector<Corner> corners(const Interface_snapshot<Complex>& interface_, int sign) const {
    std::vector<Corner> ends(interface_.vertices.size());
    std::vector<int> numbers(interface_.vertices.size(), 0); // of segments
    for (const auto& segment : interface_.facets())
      for (int i = 0; i < 2; ++i) {
        Corner& end = ends[segment.vertices[i]];
        int& number = numbers[segment.vertices[i]];
        if (number < 2 && segment.in_front == 0) {
          const Vector d = m_complex.displacement(interface_.vertices[segment.vertices[0]],
                                                  interface_.vertices[segment.vertices[1]]);
          end.edges[number] = i == 0 ? d : -d;
          end.normals[number] =
              sign / Complex::Space::length(d) * Vector(d.y(), -d.x()); // out of the left side
        }
        number += segment.in_front == 0 ? 1 : 3; // other segments count as too many
      }
    std::vector<Corner> result;
    for (std::size_t v = 0; v < ends.size(); ++v) {
      Corner& corner = ends[v];
      corner.vertex = interface_.vertices[v];
      if (numbers[v] != 2 || corner.vertex->boundary_class() != Boundary_class::inside)
        continue;
      corner.angle =
          std::acos((std::max)(-1., (std::min)(1., corner.normals[0] * corner.normals[1])));
      if (corner.edges[1] * corner.normals[0] < 0 &&
          corner.angle > (1 + rounding) * m_sharpest + rounding) // convex
        result.push_back(corner);
    }
    return result;
  }

  // Returns the arc of a corner, without vertices if the corner stays sharp.
  Arc arc_of(const Corner& corner, double distance) const {
    const double half = corner.angle / 2, edge = m_complex.mean_interface_edge();
    const auto chord = [&](int n, double radius) { return 2 * radius * std::tan(half / n); };
    Arc arc;
    arc.corner = corner;
    arc.number = (std::max)(2, int(std::ceil(corner.angle / m_finest - rounding)));
    while (arc.number > 2 && chord(arc.number, distance) < shortest * edge)
      --arc.number;
    arc.radius = (std::max)(0., shortest * edge / chord(arc.number, 1) - distance);
    const double length = (std::min)(Complex::Space::length(corner.edges[0]),
                                     Complex::Space::length(corner.edges[1]));
    arc.radius = (std::min)(arc.radius, part_of_segment * length / std::tan(half));
    arc.chord = chord(arc.number, arc.radius + distance);
    if (arc.chord < shortest * edge / 2)
      arc.number = 0;
    return arc;
  }

  // Inserts the vertices of an arc. They get their order on the arc from the first segment to the
  // second one.
  void open(const Arc& arc, double distance) {
    const Corner& corner = arc.corner;
    const int before = (arc.number - 1) / 2;
    std::vector<Vertex_handle> vertices, behind;
    insert(corner.vertex, corner.edges[0], before, arc.chord, vertices);
    vertices.push_back(corner.vertex);
    insert(corner.vertex, corner.edges[1], arc.number - 1 - before, arc.chord, behind);
    vertices.insert(vertices.end(), behind.rbegin(), behind.rend());

    const Vector bisector = corner.normals[0] + corner.normals[1];
    if (vertices.size() == 1 || !(Complex::Space::length(bisector) > 0))
      return; // the corner stays sharp
    const Point center =
        m_complex.position(corner.vertex) -
        arc.radius / (Complex::Space::length(bisector) * std::cos(corner.angle / 2)) * bisector;
    const Vector along = corner.edges[0] / Complex::Space::length(corner.edges[0]);
    // tangents of the circle meet at a larger radius
    const double step = corner.angle / double(vertices.size()), factor = 1 / std::cos(step / 2);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const double a = (double(i) + .5) * step;
      const Vector direction = std::cos(a) * corner.normals[0] - std::sin(a) * along;
      m_on_arcs.push_back(
          {vertices[i]->time_stamp(), center + factor * (arc.radius + distance) * direction});
    }
  }

  // Inserts vertices into the segment at a corner in a direction, at equal distances from the
  // corner on. Appends them to a list, the farthest first. Inserts fewer vertices if the cells do
  // not permit more.
  void insert(Vertex_handle corner, const Vector& direction, int number, double distance,
              std::vector<Vertex_handle>& vertices) {
    for (int k = number; k > 0; --k) {
      const auto [cell, end] = segment_at(corner, direction);
      const double length = Complex::Space::length(m_complex.displacement(corner, end));
      if (k == number)
        distance = (std::min)(distance, part_of_segment * length / number);
      if (!propose_edge_split(m_complex, cell, cell->index(corner), cell->index(end),
                              k * distance / length, m_cavity))
        return;
      commit_split(m_complex, m_cavity, corner, end, m_visitor, m_report);
      vertices.push_back(m_cavity.vertices().back().handle);
    }
  }

  // Returns the segment of the interface at a corner that is nearest to a direction: a cell at it
  // and its other end.
  std::pair<typename Complex::Cell_handle, Vertex_handle>
  segment_at(Vertex_handle corner, const Vector& direction) const {
    std::vector<typename Complex::Cell_handle> star;
    m_complex.star(corner, star);
    std::pair<typename Complex::Cell_handle, Vertex_handle> result;
    double best = -(std::numeric_limits<double>::max)();
    for (const auto c : star) {
      const int i = c->index(corner);
      for (int j = (i + 1) % 3; j != i; j = (j + 1) % 3) {
        if (c->subdomain_index() == c->neighbor(3 - i - j)->subdomain_index())
          continue;
        const Vector d = m_complex.displacement(corner, c->vertex(j));
        const double cosine = d * direction / Complex::Space::length(d);
        if (cosine > best) {
          best = cosine;
          result = {c, c->vertex(j)};
        }
      }
    }
    return result;
  }

  Complex& m_complex;
  Cavity<Complex> m_cavity;
  Deformation_visitor<Complex>& m_visitor;
  double m_sharpest, m_finest;
  Improvement_report m_report;
  std::vector<On_arc> m_on_arcs; // in the order of time stamps
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INTERFACE_FLOWS_INTERNAL_CORNERS_OPENED_CORNERS_2_H
