// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_WALLS_BODY_MOTION_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_WALLS_BODY_MOTION_H

#include <CGAL/Incompressible_fluids_3/Rigid_body_3.h>

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include <tuple>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Checks the numbers of a new body in a space of a dimension.
// \throws Error
inline void require_body(const Rigid_body_3& body, int dimension) {
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> inertia(body.inertia.data());
  const auto is_finite = [](const auto& v) {
    return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z());
  };
  if (!(body.mass > 0) || !std::isfinite(body.mass))
    throw Error("the mass of a body is not positive and finite: use a positive, finite number");
  if (!is_finite(body.center) || !is_finite(body.velocity) || !is_finite(body.angular_velocity))
    throw Error("the center or a velocity of a body is not finite: give finite coordinates");
  static constexpr double rounding = 1e-9; // relative
  if (!inertia.allFinite() ||
      !((inertia - inertia.transpose()).norm() <= rounding * inertia.norm()) ||
      !(inertia.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff() > 0))
    throw Error("the tensor of inertia of a body is not symmetric and positive definite: see "
                "rigid_body_of_mesh()");
  for (int axis = 0; axis < 3; ++axis) {
    const bool in_plane = dimension == 3 || axis < 2;
    if ((body.velocity[axis] != 0 && !(body.translates[std::size_t(axis)] && in_plane)) ||
        (body.angular_velocity[axis] != 0 &&
         !(body.rotates[std::size_t(axis)] && (dimension == 3 || axis == 2))))
      throw Error("a body has an initial motion along an axis that is not free: set the velocity "
                  "along the axis to 0");
  }
  if (body.rotation != std::array<double, 4>{1, 0, 0, 0})
    throw Error("the rotation of a new body is not the identity: rotate the solid instead");
}

// A velocity and an angular velocity.
struct Body_velocity
{
  Eigen::Vector3d linear = Eigen::Vector3d::Zero(), angular = Eigen::Vector3d::Zero();

  // Returns the velocity at a point, given by its vector from the center.
  Eigen::Vector3d at(const Eigen::Vector3d& arm) const { return linear + angular.cross(arm); }
};

// The place of a rigid body.
struct Body_place
{
  Eigen::Vector3d center;
  Eigen::Quaterniond rotation;

  // Returns the place after the body has moved with a velocity for a time. The rotation is Cayley's
  // transform of the angular velocity: then a point of the body moves by the time times its
  // velocity in the middle of the motion.
  Body_place moved(const Body_velocity& velocity, double time) const {
    const Eigen::Vector3d half = time / 2 * velocity.angular;
    const Eigen::Quaterniond turn(1, half.x(), half.y(), half.z());
    return {center + time * velocity.linear, (turn.normalized() * rotation).normalized()};
  }
};

// The mass and inertia of a rigid body, and its free axes in a space of a dimension.
class Body_inertia
{
public:
  Body_inertia(const Rigid_body_3& body, int dimension)
      : m_mass(body.mass), m_inertia(Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(
                               body.inertia.data())),
        m_translates(axes(body.translates)), m_rotates(axes(body.rotates)) {
    if (dimension == 2) {
      m_translates(2, 2) = 0;
      m_rotates(0, 0) = m_rotates(1, 1) = 0;
    }
  }

  double mass() const { return m_mass; }

  // Returns the tensor of inertia of a rotated body.
  Eigen::Matrix3d inertia(const Eigen::Quaterniond& rotation) const {
    const Eigen::Matrix3d r = rotation.toRotationMatrix();
    return r * m_inertia * r.transpose();
  }

  // Return the orthogonal projections onto the directions in which the center can move, and onto
  // the axes about which the body can rotate.
  const Eigen::Matrix3d& translations() const { return m_translates; }
  const Eigen::Matrix3d& rotations() const { return m_rotates; }

  // Returns the angular velocity of a rotated body with an angular momentum about its free axes.
  Eigen::Vector3d angular_velocity(const Eigen::Quaterniond& rotation,
                                   const Eigen::Vector3d& momentum) const {
    // A multiple of the inertia on the axes that are not free, so that the matrix is well scaled.
    const Eigen::Matrix3d rest =
        m_inertia.trace() * (Eigen::Matrix3d::Identity() - m_rotates).eval();
    return (m_rotates * inertia(rotation) * m_rotates + rest).ldlt().solve(m_rotates * momentum);
  }

  // Returns the kinetic energy.
  double energy(const Eigen::Quaterniond& rotation, const Body_velocity& velocity) const {
    return (m_mass * velocity.linear.squaredNorm() +
            velocity.angular.dot(inertia(rotation) * velocity.angular)) /
           2;
  }

private:
  static Eigen::Matrix3d axes(const std::array<bool, 3>& are_free) {
    return Eigen::Vector3d(are_free[0], are_free[1], are_free[2]).asDiagonal();
  }

  double m_mass;
  Eigen::Matrix3d m_inertia, m_translates, m_rotates;
};

inline Body_place place_of(const Rigid_body_3& body) {
  const auto& r = body.rotation;
  return {{body.center.x(), body.center.y(), body.center.z()}, {r[0], r[1], r[2], r[3]}};
}

inline Body_velocity velocity_of(const Rigid_body_3& body) {
  const auto& v = body.velocity;
  const auto& w = body.angular_velocity;
  return {{v.x(), v.y(), v.z()}, {w.x(), w.y(), w.z()}};
}

inline void set_motion(Rigid_body_3& body, const Body_place& place, const Body_velocity& velocity) {
  const auto& q = place.rotation;
  body.center = {place.center.x(), place.center.y(), place.center.z()};
  body.rotation = {q.w(), q.x(), q.y(), q.z()};
  body.velocity = {velocity.linear.x(), velocity.linear.y(), velocity.linear.z()};
  body.angular_velocity = {velocity.angular.x(), velocity.angular.y(), velocity.angular.z()};
}

// Moves a body by gravity alone, by the implicit midpoint rule. The angular momentum about free
// axes is preserved.
inline void move_freely(Rigid_body_3& body, const Eigen::Vector3d& gravity, double dt,
                        int dimension) {
  static constexpr int iterations = 4; // for the rotation in the middle
  const Body_inertia inertia(body, dimension);
  const Body_place begin = place_of(body);
  const Body_velocity before = velocity_of(body);
  const Eigen::Vector3d momentum = inertia.inertia(begin.rotation) * before.angular,
                        change = dt * inertia.translations() * gravity;
  Body_velocity velocity{before.linear + change / 2, before.angular};
  for (int k = 0; k < iterations; ++k)
    velocity.angular = inertia.angular_velocity(begin.moved(velocity, dt / 2).rotation, momentum);
  const Body_place end = begin.moved(velocity, dt);
  set_motion(body, end, {before.linear + change, inertia.angular_velocity(end.rotation, momentum)});
}

// Returns the numbers of `Fluid_state::bodies`.
inline std::array<double, 13> motion_of(const Rigid_body_3& body) {
  const auto& [c, q, v, w] =
      std::tie(body.center, body.rotation, body.velocity, body.angular_velocity);
  return {c.x(), c.y(), c.z(), q[0], q[1], q[2], q[3], v.x(), v.y(), v.z(), w.x(), w.y(), w.z()};
}

// Returns whether the quaternion in the numbers of `Fluid_state::bodies` is a rotation.
inline bool has_rotation(const std::array<double, 13>& n) {
  static constexpr double rounding = 1e-9;
  return std::abs(n[3] * n[3] + n[4] * n[4] + n[5] * n[5] + n[6] * n[6] - 1) <= rounding;
}

// Sets the place and motion of a body to the numbers of `Fluid_state::bodies`.
inline void set_motion(Rigid_body_3& body, const std::array<double, 13>& n) {
  body.center = {n[0], n[1], n[2]};
  body.rotation = {n[3], n[4], n[5], n[6]};
  body.velocity = {n[7], n[8], n[9]};
  body.angular_velocity = {n[10], n[11], n[12]};
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_WALLS_BODY_MOTION_H
