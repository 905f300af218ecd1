// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Incompressible_fluids_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_MOVING_SOLID_3_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_MOVING_SOLID_3_H

#include <CGAL/license/Incompressible_fluids_3.h>

#include <CGAL/Incompressible_fluids_3/Solids_3.h>

#include <cmath>
#include <functional>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/// \ingroup PkgIncompressibleFluids3Ref
/// The place and motion of a solid at some time, relative to its place before the motion.
struct Solid_motion_3
{
  using Vector = Simple_cartesian<double>::Vector_3; ///< a vector in space

  Vector displacement = Vector(0, 0, 0);     ///< the displacement of the center
  Vector rotation = Vector(0, 0, 0);         ///< the axis of rotation times the angle in radians
  Vector velocity = Vector(0, 0, 0);         ///< the velocity of the center
  Vector angular_velocity = Vector(0, 0, 0); ///< the angular velocity, in radians per unit of time
};

/// \ingroup PkgIncompressibleFluids3Ref
/// A solid whose motion is a function of time.
/// \cgalModels `Solid_3`
/// \tparam Solid a model of `Solid_3`
template <class Solid> class Moving_solid_3
{
public:
  using Point = Simple_cartesian<double>::Point_3;   ///< a point in space
  using Vector = Simple_cartesian<double>::Vector_3; ///< a vector in space
  /// A function that returns the motion at a time. Its velocities must be the derivatives of its
  /// places.
  using Motion = std::function<Solid_motion_3(double)>;

  /// Constructs a solid that moves as a function of time.
  /// \param solid the solid before the motion
  /// \param center the center of rotation, before the motion
  /// \param motion the motion
  /// \throws Error if the center is not finite. `walls()` throws if the motion is not finite.
  Moving_solid_3(const Solid& solid, const Point& center, const Motion& motion)
      : m_solid(solid), m_center(center), m_motion(motion) {
    internal::require_place(center, "center");
  }

  /// Constructs a solid with a constant velocity and a constant angular velocity.
  /// \param solid the solid at time 0
  /// \param velocity the velocity of `center`
  /// \param center the center of rotation at time 0
  /// \param angular_velocity the direction of the axis times the angular velocity, in radians per
  /// unit of time. Zero means no rotation.
  /// \throws Error if an argument other than the solid is not finite
  Moving_solid_3(const Solid& solid, const Vector& velocity, const Point& center = Point(0, 0, 0),
                 const Vector& angular_velocity = Vector(0, 0, 0))
      : Moving_solid_3(solid, center, [velocity, angular_velocity](double t) {
          return Solid_motion_3{t * velocity, t * angular_velocity, velocity, angular_velocity};
        }) {
    internal::require_place(velocity, "velocity");
    internal::require_place(angular_velocity, "angular velocity");
  }

  /// Appends the walls at time `t`.
  void walls(const Point& p, double t, std::vector<Wall_3>& result) const {
    const Solid_motion_3 motion = m_motion(t);
    for (const Vector& v :
         {motion.displacement, motion.rotation, motion.velocity, motion.angular_velocity})
      internal::require_place(v, "motion");
    const std::size_t first = result.size();
    const Vector from_center = p - (m_center + motion.displacement);
    m_solid.walls(m_center + turned(from_center, -motion.rotation), t, result);
    for (std::size_t i = first; i < result.size(); ++i) {
      Wall_3& wall = result[i];
      wall.normal = turned(wall.normal, motion.rotation);
      wall.velocity =
          turned(wall.velocity, motion.rotation) + motion.velocity +
          cross_product(motion.angular_velocity, from_center - wall.distance * wall.normal);
    }
  }

private:
  // Returns a rotated vector, by Rodrigues' formula.
  static Vector turned(const Vector& v, const Vector& rotation) {
    const double angle = std::sqrt(rotation.squared_length());
    if (!(angle > 0))
      return v;
    const Vector axis = rotation / angle;
    return std::cos(angle) * v + std::sin(angle) * cross_product(axis, v) +
           (1 - std::cos(angle)) * (axis * v) * axis;
  }

  Solid m_solid;
  Point m_center;
  Motion m_motion;
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_MOVING_SOLID_3_H
