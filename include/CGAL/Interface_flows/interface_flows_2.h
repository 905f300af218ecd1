// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_FLOWS_INTERFACE_FLOWS_2_H
#define CGAL_INTERFACE_FLOWS_INTERFACE_FLOWS_2_H

#include <CGAL/Mesh_support/coordinates.h>

#include <CGAL/Interface_flows/Normal_offset.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel_traits.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceFlowsRef

A rotation about a point with constant angular velocity. It returns positions, so the rotation is
exact up to rounding for any integration scheme. `Rigid_rotation_3` is the version in space.

\cgalModels{InterfaceFlowMap}
*/
class Rigid_rotation_2
{
public:
  using Point_2 = Epick::Point_2;   ///< a point of the complex
  using Vector_2 = Epick::Vector_2; ///< a vector in the same coordinates
  using Is_invertible = Tag_true;   ///< also moves free vertices

  /// \param center the center of the rotation
  /// \param angular_velocity radians per unit of time, counterclockwise
  Rigid_rotation_2(const Point_2& center, double angular_velocity)
      : m_center(center), m_angular_velocity(angular_velocity) {}

  /// Returns the position at the time t + dt of the point that is at p at the time t.
  Point_2 operator()(const Point_2& p, double /*t*/, double dt) const {
    const double angle = m_angular_velocity * dt;
    const Vector_2 r = p - m_center, across(-r.y(), r.x());
    return m_center + std::cos(angle) * r + std::sin(angle) * across;
  }

  /// The same for points of any kernel whose numbers are doubles.
  template <class Point>
  auto operator()(const Point& p, double t, double dt) const ->
      typename Kernel_traits<Point>::Kernel::Point_2 {
    return point_of<Point>(
        coordinates_of<2>((*this)(point_of<Point_2>(coordinates_of<2>(p)), t, dt)));
  }

private:
  Point_2 m_center;
  double m_angular_velocity;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_FLOWS_INTERFACE_FLOWS_2_H
