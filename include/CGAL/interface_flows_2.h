// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_FLOWS_2_H
#define CGAL_INTERFACE_FLOWS_2_H

#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Rotation about a point with constant angular velocity. It gives positions and not velocities, so
that it is integrated exactly, whatever the scheme: the twin of `Rigid_rotation_3`.

\cgalModels `InterfaceFlowMap_3`
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

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Motion along the normals of the interface: labelled phases grow into the outside, label 0, or shrink
if the speed is negative. The normal of a vertex is the mean of the normals of its edges that face
label 0, weighted by their lengths; vertices without such an edge stay. The twin of
`Normal_offset_3`.

\cgalModels `InterfaceVelocity_3`
*/
struct Normal_offset_2
{
  double speed; ///< length per unit of time, in the coordinates of the complex

  /// computes the velocities of vertices at positions, as `InterfaceVelocity_3` says. Linear in the
  /// size of the interface.
  template <class Complex>
  void operator()(const Interface_snapshot_2<Complex>& interface_,
                  const std::vector<typename Complex::Approximate_point>& positions, double /*t*/,
                  std::vector<typename Complex::Approximate_vector>& velocities) const {
    using Vector = typename Complex::Approximate_vector;
    velocities.assign(positions.size(), Vector(0, 0));
    for (const auto& segment : interface_.segments) {
      if (segment.in_front != 0 && segment.behind != 0)
        continue;
      const auto& v = segment.vertices;
      const Vector edge = positions[v[1]] - positions[v[0]];
      const Vector normal = Vector(edge.y(), -edge.x()) * (segment.in_front == 0 ? 1. : -1.);
      for (std::size_t i : v)
        velocities[i] = velocities[i] + normal;
    }
    for (Vector& v : velocities) {
      const double length = std::hypot(v.x(), v.y());
      v = length == 0 ? Vector(0, 0) : speed * (v / length);
    }
  }
};

} // namespace CGAL

#endif // CGAL_INTERFACE_FLOWS_2_H
