// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_BALL_DOMAIN_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_BALL_DOMAIN_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>
#include <CGAL/Deformable_simplicial_complexes/Simplex_data.h>
#include <CGAL/Deformable_simplicial_complexes/State.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/apply_to_corners.h>
#include <CGAL/Mesh_support/coordinates.h>
#include <CGAL/Mesh_support/internal/numbers/Extent.h>

#include <CGAL/enum.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Domain of a complex that is a ball, in most cases a box. The outside is represented by one infinite
vertex and its incident cells. If the domain is a box, vertices on the boundary move only within
their sides. Otherwise, they do not move.

A domain answers all questions that depend on the shape of space as a whole: which vertices and
cells are outside, where a corner of a cell is as seen from the cell, and where a vertex of the
boundary may go. In a ball, all cells see a vertex at its position.

\cgalModels{SimplicialDomain}
*/
class Ball_domain
{
public:
  /// Tells that there is a vertex outside.
  static constexpr bool has_outside = true;
  /// Tells that the boundary is a sphere.
  static constexpr bool is_ball = true;

  /// Tells that operations may change all edges and labels at a vertex.
  template <class Vertex> static constexpr bool is_constrained(const Vertex& /*v*/) {
    return false;
  }

  /// Returns whether a vertex is the infinite vertex.
  template <class Complex>
  bool is_outside(const Complex& complex, typename Complex::Vertex_handle v) const {
    return v == complex.triangulation().infinite_vertex();
  }

  /// Returns whether the infinite vertex is one of the vertices of a cell.
  template <class Complex>
  bool is_outside(const Complex& complex, typename Complex::Cell_handle c) const {
    return complex.triangulation().is_infinite(c);
  }

  /// Returns `p`, since a point has no other images.
  template <class Point> const Point& canonical(const Point& p) const { return p; }

  /// Returns `q`, since a point has no other images.
  template <class Point> const Point& nearest_image(const Point& /*p*/, const Point& q) const {
    return q;
  }

  /// Returns `f(corner(0), ...)` with the corners of a cell.
  template <class Complex, class Function, class Corner>
  decltype(auto) apply(const Function& f, const Corner& corner) const {
    return internal::apply_to_corners<Complex::corners>(f, corner);
  }

  /// Returns the orientation of a cell with these corners, exactly.
  template <class Complex, class Corner>
  Orientation orientation(const Complex& complex, const Corner& corner) const {
    return internal::apply_to_corners<Complex::corners>(complex.orientation(), corner);
  }

  /// Returns the point nearest to `q` on the sides of the domain that `v` lies on.
  template <class Complex>
  typename Complex::Point admissible(const Complex& complex, typename Complex::Vertex_handle v,
                                     const typename Complex::Point& q) const;

  /// Returns zeros: space is not periodic.
  template <int d> std::array<double, d> periods() const { return {}; }

  /// Returns the domain of a complex with the given state.
  /// \throws Invalid_cells_error if the domain was a torus
  template <int d> static Ball_domain of(const State<d>& state) {
    if (state.periods != std::array<double, d>{})
      throw Invalid_cells_error(
          "the state belongs to a complex on a torus: use the state of a complex in a ball");
    return Ball_domain();
  }

  /// Finds the sides that each vertex of the boundary lies on. Linear in the size of the boundary.
  template <class Complex> void classify_boundary(const Complex& complex) const;

  /// Returns whether a facet of the boundary stays in its side, for all permitted positions of its
  /// vertices.
  template <class Complex>
  bool keeps_side(const Complex& complex, const typename Complex::Facet& f) const;
};

template <class Complex>
typename Complex::Point Ball_domain::admissible(const Complex& complex,
                                                typename Complex::Vertex_handle v,
                                                const typename Complex::Point& q) const {
  const Boundary_class::Bits sides = v->boundary_class();
  static constexpr int d = Complex::dimension;
  if (sides == Boundary_class::inside)
    return q;
  if (Boundary_class::fixes_all(sides, d))
    return v->point();
  std::array<double, d> coordinates;
  const auto from = complex.position(v), to = q;
  for (int axis = 0; axis < d; ++axis)
    coordinates[axis] = Boundary_class::fixes(sides, axis) ? from[axis] : to[axis];
  return point_at<Complex>(coordinates);
}

template <class Complex> void Ball_domain::classify_boundary(const Complex& complex) const {
  using Vertex_handle = typename Complex::Vertex_handle;
  static constexpr int d = Complex::dimension;
  const Vertex_handle outside = complex.triangulation().infinite_vertex();
  std::vector<typename Complex::Cell_handle> star;
  complex.star(outside, star);
  std::vector<std::array<Vertex_handle, d>> hull;
  internal::Extent<d> box;
  for (auto c : star) {
    hull.push_back(complex.facet_vertices({c, c->index(outside)}));
    for (Vertex_handle v : hull.back())
      box.add(complex.position(v));
  }
  const auto sides = [&](Vertex_handle v) { return box.sides(complex.position(v)); };
  const bool is_box = std::all_of(hull.begin(), hull.end(), [&](const auto& f) {
    unsigned common = sides(f[0]);
    for (Vertex_handle v : f)
      common &= sides(v);
    return common != 0;
  });
  for (const auto& f : hull)
    for (Vertex_handle v : f)
      internal::Simplex_access::set_boundary_class(v, is_box ? sides(v) : Boundary_class::fixed);
}

template <class Complex>
bool Ball_domain::keeps_side(const Complex& complex, const typename Complex::Facet& f) const {
  const auto vertices = complex.facet_vertices(f);
  unsigned sides = vertices[0]->boundary_class();
  for (auto v : vertices)
    sides &= v->boundary_class();
  if ((sides & Boundary_class::fixed) != 0)
    return true;
  for (int axis = 0; axis < Complex::dimension; ++axis)
    if ((sides >> (2 * axis) & 3) != 0 &&
        std::all_of(vertices.begin(), vertices.end(), [&](auto v) {
          return complex.position(v)[axis] == complex.position(vertices[0])[axis];
        }))
      return true;
  return false;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_BALL_DOMAIN_H
