// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_FLOWS_INTERNAL_CORNERS_OPENED_CORNERS_3_H
#define CGAL_INTERFACE_FLOWS_INTERNAL_CORNERS_OPENED_CORNERS_3_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>
#include <CGAL/Interface_remeshing/refine_cells.h>

#include <CGAL/Origin.h>
#include <CGAL/number_utils.h>

#include <map>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The edges and vertices of surfaces from which a front moves away. By Huygens' principle, the
// front of such an edge is a part of a cylinder, and the front of a vertex a part of a sphere. The
// class inserts rows of vertices beside the edges, and returns their destinations. The facets
// between the rows are tangents of the cylinder, so a mitered motion of the next steps keeps it.
//
// A vertex at which an edge is concave, or an edge ends, stays sharp.
template <class Complex> class Opened_corners_3
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Point = typename Complex::Point;
  using Vector = typename Complex::Vector;

  // Inserts the vertices.
  // \param speed of the front, positive if labeled phases grow
  // \param dt length of the step
  // \param finest largest angle between neighboring facets of the front of an edge, in radians
  Opened_corners_3(Complex& complex, double speed, double dt, double finest,
                   Deformation_visitor<Complex>& visitor)
      : m_complex(complex), m_cavity(complex), m_visitor(visitor), m_finest(finest),
        m_sign(speed * dt > 0 ? 1 : -1), m_distance(std::abs(speed * dt)) {
    if (m_distance == 0 || !std::isfinite(m_distance))
      return;
    m_width =
        (std::max)(shortest * complex.mean_interface_edge(), 2 * m_distance * std::tan(finest / 2));
    if (!refine())
      return;
    find_centers();
    open_vertices();
    open_edges();
  }

  // Returns the number of inserted vertices.
  std::size_t inserted() const { return m_report.split; }

  // Replaces the destinations of the vertices on cylinders and spheres.
  void place(const Interface_snapshot<Complex>& interface_,
             std::vector<Point>& destinations) const {
    for (std::size_t i = 0; i < destinations.size(); ++i)
      if (const auto found = m_destinations.find(interface_.vertices[i]->time_stamp());
          found != m_destinations.end())
        destinations[i] = found->second;
  }

private:
  // Shortest width of a row, in mean edges, as in the plane.
  static constexpr double shortest = .01;
  // Edges between facets that turn by more are opened, in radians: the facets of a front that was
  // opened before turn less, also where the mesh was improved.
  static constexpr double sharpest = 60 * CGAL_PI / 180;
  // Longest edge at a vertex that is opened, in widths.
  static constexpr double coarsest = 4;
  // Part of an edge that the rows at one of its ends can take.
  static constexpr double part_of_edge = .4;

  // An edge of the interface with two facets between one label and label 0.
  struct Edge
  {
    std::array<std::size_t, 2> ends; // in the snapshot
    std::array<Vector, 2> normals;   // of the facets, in the direction of the motion
    double angle = 0;                // between them
    int facets = 0;                  // number; more than 2 if the edge cannot be opened
    std::array<Vector, 2> inner;     // from the first end to the opposite vertices

    bool is_sharp() const { return facets != 2 || angle > sharpest; }
    bool is_convex() const { return facets == 2 && inner[1] * normals[0] < 0; }
  };

  // A vertex in the middle of a front, with the position of the vertex or edge that it opens.
  struct Center
  {
    Vertex_handle vertex;
    Point base;
    Vector direction;
  };

  // A row of vertices is inserted where arms from the centers cross it.
  struct Arm
  {
    Center center;
    Vertex_handle tip, end; // the edge from the tip to the end is split next
    Vector normal;          // of the face in which the arm is
  };

  // Lists the edges of the interface.
  std::vector<Edge> edges(const Interface_snapshot<Complex>& interface_) const {
    const auto positions = interface_.positions(m_complex);
    std::map<std::pair<std::size_t, std::size_t>, Edge> found;
    for (const auto& facet : interface_.facets()) {
      const auto p = interface_.corners(facet, positions);
      const Vector normal = Complex::Space::facet_normal(p);
      const double length = Complex::Space::length(normal);
      for (int i = 0; i < 3; ++i) {
        int from = (i + 1) % 3, to = (i + 2) % 3;
        if (facet.vertices[from] > facet.vertices[to])
          std::swap(from, to);
        Edge& edge = found[{facet.vertices[from], facet.vertices[to]}];
        edge.ends = {facet.vertices[from], facet.vertices[to]};
        if (edge.facets < 2 && facet.in_front == 0 && length > 0) {
          edge.normals[edge.facets] = m_sign / length * normal;
          edge.inner[edge.facets++] = p[i] - p[from];
        } else {
          edge.facets = 3;
        }
      }
    }
    std::vector<Edge> result;
    for (auto& [ends, edge] : found) {
      if (edge.facets == 2)
        edge.angle = angle_between(edge.normals[0], edge.normals[1]);
      result.push_back(edge);
    }
    return result;
  }

  static double angle_between(const Vector& a, const Vector& b) {
    return std::atan2(Complex::Space::length(cross_product(a, b)), a * b);
  }

  // Returns for each vertex whether it is opened: it has at least two sharp edges, all of them
  // convex.
  std::vector<char> opened(const Interface_snapshot<Complex>& interface_,
                           const std::vector<Edge>& edges) const {
    std::vector<int> sharp(interface_.vertices.size(), 0);
    std::vector<char> is_blocked(sharp.size(), 0);
    for (const Edge& edge : edges)
      if (edge.is_sharp())
        for (std::size_t v : edge.ends) {
          ++sharp[v];
          is_blocked[v] = is_blocked[v] || !edge.is_convex();
        }
    std::vector<char> result;
    for (std::size_t v = 0; v < sharp.size(); ++v)
      result.push_back(sharp[v] >= 2 && !is_blocked[v] &&
                       interface_.vertices[v]->boundary_class() == Boundary_class::inside);
    return result;
  }

  // Refines the cells at the vertices that are opened, and splits other edges between them. Returns
  // whether there are such vertices.
  bool refine() {
    static constexpr int most_rounds = 30; // each halves the edges that are too long
    for (int round = 0; round < most_rounds; ++round) {
      const Interface_snapshot<Complex> interface_(m_complex);
      const std::vector<Edge> all = edges(interface_);
      const std::vector<char> is_opened = opened(interface_, all);
      if (std::find(is_opened.begin(), is_opened.end(), 1) == is_opened.end())
        return false;
      const std::size_t before = m_report.split;
      for (std::size_t v = 0; v < is_opened.size(); ++v)
        if (is_opened[v])
          m_report.split +=
              refine_around(m_complex, interface_.vertices[v], coarsest * m_width, m_visitor);
      for (const Edge& edge : all) {
        const auto [a, b] = edge.ends;
        if (!edge.is_sharp() && is_opened[a] && is_opened[b])
          split(interface_.vertices[a], interface_.vertices[b], .5);
      }
      if (m_report.split == before)
        break;
    }
    return true;
  }

  // Splits an edge, if it exists and the split is admissible. Returns the new vertex, or null.
  Vertex_handle split(Vertex_handle from, Vertex_handle to, double ratio) {
    std::vector<typename Complex::Cell_handle> star;
    m_complex.star(from, star);
    const auto cell =
        std::find_if(star.begin(), star.end(), [&](auto c) { return c->has_vertex(to); });
    if (cell == star.end() || !propose_edge_split(m_complex, *cell, (*cell)->index(from),
                                                  (*cell)->index(to), ratio, m_cavity))
      return Vertex_handle();
    commit_split(m_complex, m_cavity, from, to, m_visitor, m_report);
    return m_cavity.vertices().back().handle;
  }

  // Splits an edge at the width of a row from its first end.
  Vertex_handle split_at_width(Vertex_handle from, Vertex_handle to, double width) {
    const double length = Complex::Space::length(m_complex.displacement(from, to));
    return length > width ? split(from, to, width / length) : Vertex_handle();
  }

  // Finds the vertices that are opened, and the number of rows.
  void find_centers() {
    const Interface_snapshot<Complex> interface_(m_complex);
    const std::vector<Edge> all = edges(interface_);
    const std::vector<char> is_opened = opened(interface_, all);
    std::vector<Vector> sums(is_opened.size(), NULL_VECTOR);
    std::vector<int> sharp(is_opened.size(), 0);
    double largest = 0;
    for (const Edge& edge : all)
      if (edge.is_sharp())
        for (std::size_t v : edge.ends)
          if (is_opened[v]) {
            sums[v] = sums[v] + edge.normals[0] + edge.normals[1];
            ++sharp[v];
            largest = (std::max)(largest, edge.angle);
          }
    m_rows = (std::max)(1, int(std::ceil((largest / m_finest - 1) / 2 - 1e-6)));
    std::vector<Center> centers(is_opened.size());
    for (std::size_t v = 0; v < is_opened.size(); ++v)
      if (is_opened[v] && Complex::Space::length(sums[v]) > 0)
        centers[v] = {interface_.vertices[v], m_complex.position(interface_.vertices[v]),
                      sums[v] / Complex::Space::length(sums[v])};
    std::vector<double> widest(is_opened.size(), 0);
    for (const Edge& edge : all)
      for (std::size_t v : edge.ends)
        if (centers[v].vertex != Vertex_handle())
          for (const Vector& normal : edge.normals)
            widest[v] = (std::max)(widest[v], angle_between(centers[v].direction, normal));
    for (std::size_t v = 0; v < is_opened.size(); ++v)
      if (centers[v].vertex != Vertex_handle())
        set_destination(centers[v], centers[v].vertex, centers[v].direction, widest[v]);
    for (const Edge& edge : all)
      for (int i = 0; i < 2; ++i)
        if (const Center& center = centers[edge.ends[i]];
            center.vertex != Vertex_handle() && edge.facets == 2) {
          const Vector sum = edge.normals[0] + edge.normals[1];
          const Arm arm = {center, center.vertex, interface_.vertices[edge.ends[1 - i]],
                           sum / Complex::Space::length(sum)};
          if (!edge.is_sharp())
            m_arms.push_back(arm);
          else if (sharp[edge.ends[i]] > 2)
            m_arms_on_edges.push_back({arm, edge.normals});
        }
  }

  // Sends a vertex to a tangent plane: `angle` is the angle from the middle of the front to its
  // side, of which each row takes an equal part.
  void set_destination(const Center& center, Vertex_handle v, const Vector& direction,
                       double angle) {
    const double factor = 1 / std::cos(angle / (2 * m_rows + 1));
    m_destinations[v->time_stamp()] = center.base + factor * m_distance * direction;
  }

  // Returns the unit vector at a part of the angle between two unit vectors.
  static Vector between(const Vector& a, const Vector& b, double part) {
    const double angle = angle_between(a, b);
    if (!(std::sin(angle) > 0))
      return a;
    return std::sin((1 - part) * angle) / std::sin(angle) * a +
           std::sin(part * angle) / std::sin(angle) * b;
  }

  // Inserts vertices into the edges at a vertex of a polyhedron. They are between its sphere and
  // the cylinders, and get arms of their own.
  void open_vertices() {
    for (auto& [arm, normals] : m_arms_on_edges) {
      const double length = Complex::Space::length(m_complex.displacement(arm.tip, arm.end));
      const double width = (std::min)(m_width, part_of_edge * length / m_rows);
      for (int row = 1; row <= m_rows; ++row) {
        const Vertex_handle v = split_at_width(arm.tip, arm.end, width);
        if (v == Vertex_handle())
          break;
        const Center center = {v, arm.center.base,
                               between(arm.center.direction, arm.normal, double(row) / m_rows)};
        set_destination(center, v, center.direction, angle_between(center.direction, normals[0]));
        m_new_centers.emplace(v->time_stamp(), center);
        arm.tip = v;
      }
    }
    if (m_new_centers.empty())
      return;
    const Interface_snapshot<Complex> interface_(m_complex);
    for (const Edge& edge : edges(interface_))
      for (int i = 0; i < 2; ++i)
        if (const auto found = m_new_centers.find(interface_.vertices[edge.ends[i]]->time_stamp());
            found != m_new_centers.end() && !edge.is_sharp()) {
          const Vector sum = edge.normals[0] + edge.normals[1];
          m_arms.push_back({found->second, found->second.vertex,
                            interface_.vertices[edge.ends[1 - i]],
                            sum / Complex::Space::length(sum)});
        }
  }

  // Inserts the rows, the one next to the edges first, so that facets are between rows.
  void open_edges() {
    for (int row = 1; row <= m_rows; ++row)
      for (Arm& arm : m_arms) {
        if (arm.end == Vertex_handle())
          continue;
        const double length = Complex::Space::length(m_complex.displacement(arm.tip, arm.end));
        const double width = (std::min)(m_width, part_of_edge * length / (m_rows - row + 1));
        const Vertex_handle v = split_at_width(arm.tip, arm.end, width);
        if (v == Vertex_handle()) {
          arm.end = v; // no further rows
          continue;
        }
        set_destination(arm.center, v,
                        between(arm.center.direction, arm.normal, row / (m_rows + .5)),
                        angle_between(arm.center.direction, arm.normal));
        arm.tip = v;
      }
  }

  Complex& m_complex;
  Cavity<Complex> m_cavity;
  Deformation_visitor<Complex>& m_visitor;
  double m_finest;
  int m_sign;
  double m_distance, m_width = 0;
  int m_rows = 0; // of vertices on each side of an edge
  Improvement_report m_report;
  std::vector<Arm> m_arms;
  std::vector<std::pair<Arm, std::array<Vector, 2>>> m_arms_on_edges; // with normals of the faces
  std::unordered_map<std::size_t, Center> m_new_centers;              // by time stamp
  std::unordered_map<std::size_t, Point> m_destinations;              // by time stamp
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INTERFACE_FLOWS_INTERNAL_CORNERS_OPENED_CORNERS_3_H
