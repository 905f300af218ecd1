// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_FLOWS_VELOCITY_FIELDS_2_H
#define CGAL_INTERFACE_FLOWS_VELOCITY_FIELDS_2_H

#include <CGAL/Mesh_support/coordinates.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/number_utils.h>

#include <cmath>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceFlowsRef

The single vortex of Bell, Colella and Glaz: the curl of
\f$\psi = -\sin^2(\pi x) \sin^2(\pi y) / \pi\f$, multiplied by \f$\cos(\pi t / T)\f$ with the period
T. The velocity changes its direction at t = T / 2, and at t = T each point is back at its start.
The field preserves areas and maps the unit square to itself. `Single_vortex_velocity_3` is the
version in space.

\cgalModels{VelocityField}
*/
class Single_vortex_velocity_2
{
public:
  using Point_2 = Epick::Point_2;   ///< a point of the unit square
  using Vector_2 = Epick::Vector_2; ///< a vector in the same coordinates

  /// \param period the period T.
  /// \pre `period` is positive.
  explicit Single_vortex_velocity_2(double period = 8) : m_period(period) {}

  /// Returns the velocity at the point p, of any kernel of doubles, at the time t.
  template <class Point = Point_2>
  auto operator()(const Point& p, double t) const ->
      typename Kernel_traits<Point>::Kernel::Vector_2 {
    using Vector = typename Kernel_traits<Point>::Kernel::Vector_2;
    const double sx = std::sin(CGAL_PI * p.x()), cx = std::cos(CGAL_PI * p.x());
    const double sy = std::sin(CGAL_PI * p.y()), cy = std::cos(CGAL_PI * p.y());
    const double f = 2 * sx * sy * std::cos(CGAL_PI * t / m_period);
    return f * Vector(-sx * cy, cx * sy);
  }

private:
  double m_period;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_FLOWS_VELOCITY_FIELDS_2_H
