// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_FLOWS_INTERFACE_FLOWS_3_H
#define CGAL_INTERFACE_FLOWS_INTERFACE_FLOWS_3_H

#include <CGAL/Mesh_support/coordinates.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Interface_flows/Normal_offset.h>
#include <CGAL/Kernel_traits.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceFlowsRef

A rotation about an axis with constant angular velocity (section 4.1.1 of the paper). It returns
positions, so the rotation is exact up to rounding for any integration scheme.

\cgalModels{InterfaceFlowMap}
*/
class Rigid_rotation_3
{
public:
  using Point_3 = Epick::Point_3;   ///< a point of the complex
  using Vector_3 = Epick::Vector_3; ///< a vector in the same coordinates
  using Is_invertible = Tag_true;   ///< also moves free vertices

  /// \param center a point of the axis
  /// \param axis the direction of the axis, of any length
  /// \param angular_velocity radians per unit of time. The rotation is counterclockwise for an
  ///        observer towards whom the axis points.
  /// \pre `axis` is not zero.
  Rigid_rotation_3(const Point_3& center, const Vector_3& axis, double angular_velocity)
      : m_center(center), m_axis(axis / std::hypot(axis.x(), axis.y(), axis.z())),
        m_angular_velocity(angular_velocity) {}

  /// Returns the position at the time t + dt of the point that is at p at the time t.
  Point_3 operator()(const Point_3& p, double /*t*/, double dt) const {
    const double angle = m_angular_velocity * dt;
    const Vector_3 r = p - m_center, along = (m_axis * r) * m_axis, across = r - along;
    return m_center + along + std::cos(angle) * across +
           std::sin(angle) * cross_product(m_axis, across);
  }

  /// The same for points of any kernel whose numbers are doubles.
  template <class Point>
  auto operator()(const Point& p, double t, double dt) const ->
      typename Kernel_traits<Point>::Kernel::Point_3 {
    return point_of<Point>(
        coordinates_of<3>((*this)(point_of<Point_3>(coordinates_of<3>(p)), t, dt)));
  }

private:
  Point_3 m_center;
  Vector_3 m_axis;
  double m_angular_velocity;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_FLOWS_INTERFACE_FLOWS_3_H
