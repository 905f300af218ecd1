// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DOMAINS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DOMAINS_H

#include <CGAL/Deformable_simplicial_complexes/State.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/apply_to_corners.h>
#include <CGAL/Deformable_simplicial_complexes/simplex_bases.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/coordinates.h>
#include <CGAL/Mesh_support/internal/numbers/Extent.h>

#include <CGAL/enum.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

The sides of the domain that a vertex lies on, as bits. In a box, the bits 0 to 5 are the sides x
minimum, x maximum, y minimum, and so on. A vertex on a face has one bit, a vertex on an edge two,
and a corner three. The vertex moves within all its sides. If the domain is not a box, all vertices
on its boundary are `fixed`. A vertex in the interior has no bit. Bit 7 is free for domains.
*/
struct Boundary_class
{
  using Bits = std::uint8_t;        ///< set of sides
  static constexpr Bits inside = 0; ///< on no side
  /// on the boundary of a domain that is not a box; the vertex may not move
  static constexpr Bits fixed = 64;

  /// Returns whether motion along an axis (0, 1, 2) leaves the sides.
  static bool fixes(Bits sides, int axis) {
    return (sides & fixed) != 0 || (sides >> (2 * axis) & 3) != 0;
  }

  /// Returns whether any motion leaves the sides, in a space of the given dimension.
  static bool fixes_all(Bits sides, int dimension) {
    int axis = 0;
    while (axis < dimension && fixes(sides, axis))
      ++axis;
    return axis == dimension;
  }

  /// Returns whether the set `sides` contains all sides of the set `others`.
  static bool contains(Bits sides, Bits others) { return (sides & others) == others; }
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Exception thrown if given cells do not form a valid mesh of the domain: a ball or a torus without
flat or inverted cells.
*/
class Invalid_cells_error : public Error
{
public:
  /// Constructs the error; the arguments are returned by the functions below.
  explicit Invalid_cells_error(const std::string& message, std::vector<std::size_t> tetrahedra = {},
                               std::vector<std::size_t> vertices = {})
      : Error(message), m_tetrahedra(std::move(tetrahedra)), m_vertices(std::move(vertices)) {}

  /// Returns the indices of the offending cells, increasing: tetrahedra in 3D, triangles in 2D.
  const std::vector<std::size_t>& tetrahedra() const { return m_tetrahedra; }

  /// Returns the indices of the offending vertices.
  const std::vector<std::size_t>& vertices() const { return m_vertices; }

private:
  std::vector<std::size_t> m_tetrahedra, m_vertices;
};

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

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Domain of a complex that has any shape: any number of components, handles and cavities. It may touch
itself in vertices and along edges. The complex then has a copy of such a vertex for each set of
cells that are connected through facets at the vertex. If the domain is a box, vertices on the
boundary move only within their sides. Otherwise, they do not move. `assign_solid_3()` makes
complexes in such domains, and `improve_mesh()` improves them.

\cgalModels{SimplicialDomain}
*/
class Solid_domain : public Ball_domain
{
public:
  /// Tells that the domain can have any shape.
  static constexpr bool is_ball = false;

  /// Returns the domain, for any state.
  template <int d> static Solid_domain of(const State<d>& /*state*/) { return Solid_domain(); }
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Domain of a complex that is a flat torus. Space is periodic along each axis, so that there is no
boundary and no outside.

A vertex has one position, in the box from the origin to the periods, and infinitely many images.
Along each axis, the nearest image is used. The distance of two vertices of a cell along an axis
must therefore be less than half a period. A cell with a larger distance is treated as flat.

Positions are multiples of a power of two, at most 2<sup>-50</sup> of the largest period. All images
as seen from the box are thus doubles, and no rounding occurs across the seam.

\tparam d the dimension

\cgalModels{SimplicialDomain}
*/
template <int d> class Torus_domain
{
public:
  /// Tells that there is no vertex outside.
  static constexpr bool has_outside = false;
  /// Tells that the boundary is not a sphere.
  static constexpr bool is_ball = false;

  /// Tells that operations may change all edges and labels at a vertex.
  template <class Vertex> static constexpr bool is_constrained(const Vertex& /*v*/) {
    return false;
  }

  /// Constructs a torus with the given periods.
  /// \param periods positive lengths of similar size; they are rounded to multiples of the unit of
  ///        positions
  /// \throws Error if a period is not in [1e-30, 1e30], or is at most 2<sup>-20</sup> of the
  ///         largest one
  explicit Torus_domain(const std::array<double, d>& periods = unit_periods());

  /// Returns the domain of a complex with the given state.
  /// \throws Invalid_cells_error if the domain was not a torus, or its periods are not valid
  static Torus_domain of(const State<d>& state);

  /// Returns the period along each axis.
  template <int = d> const std::array<double, d>& periods() const { return m_periods; }

  /// Returns the total measure of all cells.
  double measure() const {
    double result = 1;
    for (double period : m_periods)
      result *= period;
    return result;
  }

  /// Returns false: no vertex is outside.
  template <class Complex>
  bool is_outside(const Complex& /*complex*/, typename Complex::Vertex_handle /*v*/) const {
    return false;
  }

  /// Returns false: no cell is outside.
  template <class Complex>
  bool is_outside(const Complex& /*complex*/, typename Complex::Cell_handle /*c*/) const {
    return false;
  }

  /// Returns the image of `p` in the box from the origin to the periods, rounded to the unit of
  /// positions.
  template <class Point> Point canonical(const Point& p) const;

  /// Returns the image of `q` that is nearest to `p` along each axis.
  template <class Point> Point nearest_image(const Point& p, const Point& q) const;

  /// Returns `f(corner(0), ...)` with the corners of a cell, as images nearest to the first corner.
  template <class Complex, class Function, class Corner>
  auto apply(const Function& f, const Corner& corner) const {
    return internal::apply_to_corners<d + 1>(
        f, [images = images<Complex>(corner)](int i) { return images[i]; });
  }

  /// Returns the orientation of a cell with these corners, exactly; `ZERO` if the cell is too long.
  template <class Complex, class Corner>
  Orientation orientation(const Complex& complex, const Corner& corner) const;

  /// Returns `q`: vertices may go anywhere.
  template <class Complex>
  typename Complex::Point admissible(const Complex& /*complex*/,
                                     typename Complex::Vertex_handle /*v*/,
                                     const typename Complex::Point& q) const {
    return q;
  }

private:
  static std::array<double, d> unit_periods() {
    std::array<double, d> result;
    result.fill(1);
    return result;
  }

  template <class Complex, class Corner> auto images(const Corner& corner) const {
    std::array<typename Complex::Point, d + 1> result;
    for (int i = 0; i <= d; ++i)
      result[i] = nearest_image(i == 0 ? corner(0) : result[0], corner(i));
    return result;
  }

  template <class Points> bool are_close(const Points& points) const {
    for (int i = 0; i <= d; ++i)
      for (int j = 0; j < i; ++j)
        for (int axis = 0; axis < d; ++axis)
          if (!(std::abs(points[i][axis] - points[j][axis]) < m_periods[axis] / 2))
            return false;
    return true;
  }

  std::array<double, d> m_periods;
  double m_unit; // unit of positions
};

template <int d>
Torus_domain<d>::Torus_domain(const std::array<double, d>& periods) : m_periods(periods) {
  // Two bits are reserved for images on both sides of the box, as seen from any point in it.
  static constexpr int bits = 51;
  static constexpr double shortest = 1e-30, longest = 1e30; // as in all domains
  static constexpr double flattest = 1. / (1 << 20);        // leaves 30 bits for the shortest axis
  double largest = 0;
  for (double period : periods) {
    if (!(period >= shortest && period <= longest))
      throw Error("a period of the torus is not between 1e-30 and 1e30: scale the periods");
    largest = (std::max)(largest, period);
  }
  m_unit = std::ldexp(1., std::ilogb(largest) - bits);
  for (double& period : m_periods) {
    if (!(period > flattest * largest))
      throw Error("a period of the torus is less than a millionth of another: use similar periods");
    period = std::round(period / m_unit) * m_unit;
  }
}

template <int d> Torus_domain<d> Torus_domain<d>::of(const State<d>& state) try {
  return Torus_domain(state.periods);
} catch (const Error&) {
  throw Invalid_cells_error(
      "the state does not belong to a complex on a torus: use the state of such a complex");
}

template <int d> template <class Point> Point Torus_domain<d>::canonical(const Point& p) const {
  std::array<double, d> x;
  for (int axis = 0; axis < d; ++axis) {
    const double period = m_periods[axis];
    x[axis] = p[axis] - period * std::floor(p[axis] / period);
    x[axis] = std::round(x[axis] / m_unit) * m_unit;
    // Rounding may give either end of the period.
    if (x[axis] >= period)
      x[axis] -= period;
    else if (x[axis] < 0)
      x[axis] += period;
  }
  return point_of<Point>(x);
}

template <int d>
template <class Point>
Point Torus_domain<d>::nearest_image(const Point& p, const Point& q) const {
  std::array<double, d> x;
  for (int axis = 0; axis < d; ++axis)
    x[axis] = q[axis] + m_periods[axis] * std::round((p[axis] - q[axis]) / m_periods[axis]);
  return point_of<Point>(x);
}

template <int d>
template <class Complex, class Corner>
Orientation Torus_domain<d>::orientation(const Complex& complex, const Corner& corner) const {
  const auto points = images<Complex>([&](int i) { return corner(i); });
  if (!are_close(points))
    return ZERO;
  return internal::apply_to_corners<d + 1>(complex.orientation(), [&](int i) { return points[i]; });
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DOMAINS_H
