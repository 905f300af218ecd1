// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_TORUS_DOMAIN_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_TORUS_DOMAIN_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/State.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/apply_to_corners.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/coordinates.h>

#include <CGAL/enum.h>

namespace CGAL::Deformable_simplicial_complexes {

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

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_TORUS_DOMAIN_H
