// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_TORUS_DOMAIN_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_TORUS_DOMAIN_H

#include <CGAL/Deformable_simplicial_complexes/State.h>
#include <CGAL/Deformable_simplicial_complexes/coordinates.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/apply_to_corners.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

The domain of a complex that is a flat torus: space repeats itself along each axis after a period,
so there is no boundary and no outside.

A vertex has one position, in the box from the origin to the periods, and infinitely many images.
What sees a vertex sees the image that is nearest along each axis; so no two vertices of a cell may
be half a period or more apart along an axis. A cell that would be counts as flat.

Nothing is rounded on the way across the seam: positions are multiples of a power of two, at most
2<sup>-50</sup> of the largest period, so that all images seen from the box are doubles.

\tparam d the dimension

\cgalModels{SimplicialDomain}
*/
template <int d> class Torus_domain
{
public:
  /// There is no vertex outside.
  static constexpr bool has_outside = false;

  /// \param periods more than 0, of similar size; they are rounded to multiples of the unit of
  ///        positions
  /// \throws Error if a period is not in [1e-30, 1e30], or 2<sup>-20</sup> of the largest or less
  explicit Torus_domain(const std::array<double, d>& periods = unit_periods());

  /// The domain of a complex in some state.
  /// \throws Invalid_cells_error if it was no torus, or one of other periods than can be
  static Torus_domain of(const State<d>& state);

  /// The length after which space repeats itself, for each axis.
  template <int = d> const std::array<double, d>& periods() const { return m_periods; }

  /// What all cells measure together.
  double measure() const {
    double result = 1;
    for (double period : m_periods)
      result *= period;
    return result;
  }

  /// False: no vertex is outside.
  template <class Complex>
  bool is_outside(const Complex& /*complex*/, typename Complex::Vertex_handle /*v*/) const {
    return false;
  }

  /// False: no cell is outside.
  template <class Complex>
  bool is_outside(const Complex& /*complex*/, typename Complex::Cell_handle /*c*/) const {
    return false;
  }

  /// The image of `p` in the box from the origin to the periods, in units of positions.
  template <class Point> Point canonical(const Point& p) const;

  /// The image of `q` that is nearest to `p` along each axis.
  template <class Point> Point near(const Point& p, const Point& q) const;

  /// `f(corner(0), ...)` with the images of the corners of a cell that are nearest to the first.
  template <class Complex, class Function, class Corner>
  auto apply(const Function& f, const Corner& corner) const {
    return internal::apply_to_corners<d + 1>(
        f, [images = images<Complex>(corner)](int i) { return images[i]; });
  }

  /// The orientation of a cell with these corners, exactly; `ZERO` if it is too long.
  template <class Complex, class Corner>
  Orientation orientation(const Complex& complex, const Corner& corner) const;

  /// `q`: vertices may go anywhere.
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
    std::array<typename Complex::Approximate_point, d + 1> result;
    for (int i = 0; i <= d; ++i)
      result[i] = near(i == 0 ? corner(0) : result[0], corner(i));
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
  double m_unit; // of positions
};

template <int d>
Torus_domain<d>::Torus_domain(const std::array<double, d>& periods) : m_periods(periods) {
  // Two bits are for the images on both sides of the box, as seen from anywhere in it.
  static constexpr int bits = 51;
  static constexpr double shortest = 1e-30, longest = 1e30; // as of all domains
  static constexpr double flattest = 1. / (1 << 20);        // leaves 30 bits along that axis
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
  throw Invalid_cells_error("the state is none of a complex on a torus");
}

template <int d> template <class Point> Point Torus_domain<d>::canonical(const Point& p) const {
  std::array<double, d> x;
  for (int axis = 0; axis < d; ++axis) {
    const double period = m_periods[axis];
    x[axis] = p[axis] - period * std::floor(p[axis] / period);
    x[axis] = std::round(x[axis] / m_unit) * m_unit;
    // Rounding may lead to either end.
    if (x[axis] >= period)
      x[axis] -= period;
    else if (x[axis] < 0)
      x[axis] += period;
  }
  return point_of<Point>(x);
}

template <int d>
template <class Point>
Point Torus_domain<d>::near(const Point& p, const Point& q) const {
  std::array<double, d> x;
  for (int axis = 0; axis < d; ++axis)
    x[axis] = q[axis] + m_periods[axis] * std::round((p[axis] - q[axis]) / m_periods[axis]);
  return point_of<Point>(x);
}

template <int d>
template <class Complex, class Corner>
Orientation Torus_domain<d>::orientation(const Complex& complex, const Corner& corner) const {
  const auto points = images<Complex>([&](int i) { return complex.approximate(corner(i)); });
  if (!are_close(points))
    return ZERO;
  return internal::apply_to_corners<d + 1>(complex.orientation(),
                                           [&](int i) { return complex.exact(points[i]); });
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_TORUS_DOMAIN_H
