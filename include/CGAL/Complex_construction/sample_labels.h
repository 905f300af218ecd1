// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_SAMPLE_LABELS_H
#define CGAL_COMPLEX_CONSTRUCTION_SAMPLE_LABELS_H

#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/coordinates.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <limits>
#include <tuple>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgComplexConstructionRef

The points of a regular grid, such as the centers of the voxels or pixels of an image.

\tparam d the dimension
*/
template <int d> struct Sampling_grid
{
  std::array<std::size_t, d> size; ///< number of points along each axis, positive
  std::array<double, d> spacing;   ///< distance of neighbors, positive and finite
  std::array<double, d> origin;    ///< coordinates of the first point, finite

  /// Returns the number of points.
  /// \throws Error if a value is out of its range
  std::size_t number_of_points() const {
    std::size_t result = 1;
    for (int axis = 0; axis < d; ++axis) {
      if (!(spacing[axis] > 0 && std::isfinite(spacing[axis]) && std::isfinite(origin[axis])))
        throw Error("the spacing of a grid is not positive, or its origin is not finite");
      if (size[axis] == 0 || size[axis] > (std::numeric_limits<std::size_t>::max)() / result)
        throw Error("the size of a grid is 0 or too large");
      result *= size[axis];
    }
    return result;
  }
};

namespace internal {

// The points of a grid in one cell.
template <class Complex> class Cell_sampler
{
public:
  static constexpr int d = Complex::dimension;
  using Cell_handle = typename Complex::Cell_handle;
  using Point = typename Complex::Point;
  using Index = std::array<std::size_t, d>;

  Cell_sampler(const Complex& complex, const Sampling_grid<d>& grid)
      : m_complex(complex), m_orientation(complex.orientation()), m_grid(grid) {}

  // Calls visit(k) for the index of each point in the cell or on its boundary. The first axis is
  // the fastest.
  template <class Visit> void operator()(Cell_handle c, const Visit& visit) const {
    Index first, last;
    for (int axis = 0; axis < d; ++axis)
      if (!find_range(c, axis, first[axis], last[axis]))
        return;
    for (Index i = first;;) {
      if (contains(c, i))
        visit(index_of(i));
      int axis = 0;
      while (axis < d && i[axis] == last[axis]) {
        i[axis] = first[axis];
        ++axis;
      }
      if (axis == d)
        return;
      ++i[axis];
    }
  }

private:
  double coordinate(int axis, std::size_t i) const {
    return m_grid.origin[axis] + double(i) * m_grid.spacing[axis];
  }

  // Finds the points along an axis that can be in the cell. Returns whether there are any. The
  // range is one point larger on both sides, because of rounding errors.
  bool find_range(Cell_handle c, int axis, std::size_t& first, std::size_t& last) const {
    double least = std::numeric_limits<double>::infinity(), largest = -least;
    for (int i = 0; i <= d; ++i) {
      const double x = m_complex.user_position(c->vertex(i))[axis];
      least = (std::min)(least, x);
      largest = (std::max)(largest, x);
    }
    const auto place = [&](double x) { return (x - m_grid.origin[axis]) / m_grid.spacing[axis]; };
    const double end = double(m_grid.size[axis] - 1), begin = std::floor(place(least)) - 1,
                 behind = std::ceil(place(largest)) + 1;
    if (!(behind >= 0 && begin <= end))
      return false;
    first = std::size_t((std::max)(0., begin));
    last = std::size_t((std::min)(end, behind));
    return true;
  }

  // The predicate is exact for the coordinates that the complex stores.
  bool contains(Cell_handle c, const Index& index) const {
    const auto& normalization = m_complex.normalization();
    std::array<double, d> x;
    for (int axis = 0; axis < d; ++axis)
      x[axis] =
          (coordinate(axis, index[axis]) - normalization.translation[axis]) / normalization.scale;
    const auto p = point_at<Complex>(x);
    std::array<typename Complex::Point, d + 1> corners;
    for (int i = 0; i <= d; ++i)
      corners[i] = c->vertex(i)->point();
    for (int i = 0; i <= d; ++i) {
      auto moved = corners;
      moved[i] = p;
      if (std::apply(m_orientation, moved) == NEGATIVE)
        return false;
    }
    return true;
  }

  std::size_t index_of(const Index& i) const {
    std::size_t result = 0;
    for (int axis = d; axis-- > 0;)
      result = result * m_grid.size[axis] + i[axis];
    return result;
  }

  const Complex& m_complex;
  decltype(std::declval<const Complex&>().orientation()) m_orientation;
  const Sampling_grid<d>& m_grid;
};

} // namespace internal

/*!
\ingroup PkgComplexConstructionRef

Returns the labels at the points of a grid, such as a labeled image of a complex. A point on a
facet gets the smallest label of its cells.

\tparam Complex a deformable simplicial complex whose domain is not a torus

\param complex the complex
\param grid the grid, in user coordinates
\param outside the label of points outside the domain

\return a label for each point, the first axis fastest

\throws Error if the grid is not valid, see `Sampling_grid::number_of_points()`
\throws Interrupted_error if the callback of a `Progress_scope` returned `false`

Linear in the number of points and cells.
*/
template <class Complex>
std::vector<typename Complex::Label> sample_labels(const Complex& complex,
                                                   const Sampling_grid<Complex::dimension>& grid,
                                                   typename Complex::Label outside = 0) {
  const Progress_phase phase("sampling labels");
  const std::size_t n = grid.number_of_points();
  std::vector<typename Complex::Label> result(n, outside);
  std::vector<bool> is_inside(n, false);
  const internal::Cell_sampler<Complex> sampler(complex, grid);
  for (const typename Complex::Cell_handle c : complex.finite_cells()) {
    Progress_scope::check();
    sampler(c, [&](std::size_t i) {
      result[i] = is_inside[i] ? (std::min)(result[i], complex.label(c)) : complex.label(c);
      is_inside[i] = true;
    });
  }
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_COMPLEX_CONSTRUCTION_SAMPLE_LABELS_H
