// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_FLOWS_INTERFACE_FLOWS_2_H
#define CGAL_INTERFACE_FLOWS_INTERFACE_FLOWS_2_H

#include <CGAL/Interface_flows/Normal_offset.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/tags.h>

#include <cmath>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceFlowsRef

Rotation about a point with constant angular velocity. It gives positions and not velocities, so
that it is integrated exactly, whatever the scheme: the twin of `Rigid_rotation_3`.

\cgalModels `InterfaceFlowMap`
*/
class Rigid_rotation_2
{
public:
  using Point_2 = Simple_cartesian<double>::Point_2;   ///< in the coordinates of the complex
  using Vector_2 = Simple_cartesian<double>::Vector_2; ///< in the coordinates of the complex
  using Is_invertible = Tag_true;                      ///< space goes with it

  /// \param center the point that stays
  /// \param angular_velocity radians per unit of time, counterclockwise
  Rigid_rotation_2(const Point_2& center, double angular_velocity)
      : m_center(center), m_angular_velocity(angular_velocity) {}

  /// Where a point at p at the time t is at t + dt.
  Point_2 operator()(const Point_2& p, double /*t*/, double dt) const {
    const double angle = m_angular_velocity * dt;
    const Vector_2 r = p - m_center, across(-r.y(), r.x());
    return m_center + std::cos(angle) * r + std::sin(angle) * across;
  }

private:
  Point_2 m_center;
  double m_angular_velocity;
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INTERFACE_FLOWS_INTERFACE_FLOWS_2_H
