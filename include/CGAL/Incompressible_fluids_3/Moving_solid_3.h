// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_MOVING_SOLID_3_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_MOVING_SOLID_3_H

#include <CGAL/Incompressible_fluids_3/Solids_3.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/fluid_vectors.h>

#include <functional>
#include <mutex>
#include <optional>

namespace CGAL::Deformable_simplicial_complexes {

/// \ingroup PkgIncompressibleFluids3Ref
/// The place and motion of a solid at some time, relative to its place before the motion.
struct Solid_motion_3
{
  using Vector = Epick::Vector_3; ///< a vector in space

  Vector displacement = Vector(0, 0, 0);     ///< the displacement of the center
  Vector rotation = Vector(0, 0, 0);         ///< the axis of rotation times the angle in radians
  Vector velocity = Vector(0, 0, 0);         ///< the velocity of the center
  Vector angular_velocity = Vector(0, 0, 0); ///< the angular velocity, in radians per unit of time
};

/// \ingroup PkgIncompressibleFluids3Ref
/// The place of a solid at some time, relative to its place before the motion.
struct Solid_place_3
{
  using Vector = Epick::Vector_3; ///< a vector in space

  Vector displacement = Vector(0, 0, 0); ///< the displacement of the center
  Vector rotation = Vector(0, 0, 0);     ///< the axis of rotation times the angle in radians
};

namespace internal {

// Returns the rotation by a rotation vector.
inline Eigen::Quaterniond rotation_by(const Solid_place_3::Vector& rotation) {
  const Eigen::Vector3d v = eigen_vector(rotation);
  return Eigen::Quaterniond(Eigen::AngleAxisd(v.norm(), v.stableNormalized()));
}

// Returns the rotation vector from one rotation to another.
inline Solid_place_3::Vector rotation_from_to(const Solid_place_3::Vector& from,
                                              const Solid_place_3::Vector& to) {
  const Eigen::AngleAxisd result(rotation_by(to) * rotation_by(from).conjugate());
  return from_eigen<Solid_place_3::Vector>(Eigen::Vector3d(result.angle() * result.axis()));
}

// A motion that is evaluated once for all points at a time. Copies share the motion at the last
// time. The function is called without the mutex, because it may use the fluid.
class Last_motion
{
public:
  using Motion = std::function<Solid_motion_3(double)>;

  explicit Last_motion(Motion motion)
      : m_motion(std::move(motion)), m_last(std::make_shared<Last>()) {}

  Solid_motion_3 operator()(double t) const {
    {
      const std::lock_guard<std::mutex> lock(m_last->mutex);
      if (m_last->time == t)
        return m_last->motion;
    }
    const Solid_motion_3 result = m_motion(t);
    const std::lock_guard<std::mutex> lock(m_last->mutex);
    m_last->time = t;
    m_last->motion = result;
    return result;
  }

private:
  struct Last
  {
    std::mutex mutex;
    std::optional<double> time;
    Solid_motion_3 motion;
  };

  Motion m_motion;
  std::shared_ptr<Last> m_last;
};

} // namespace internal

/// \ingroup PkgIncompressibleFluids3Ref
/// Returns the motion of a solid whose place is a function of time. Its velocities are differences
/// of places, with errors of second order in the step. They are central differences. Before the
/// time `step`, they are one-sided, so that no place at a negative time is evaluated.
///
/// The function must be continuous, with a continuous derivative. The solid must rotate by less
/// than half a turn in a time of two steps. Larger rotations are taken for their remainder.
/// \param place_at a function that returns the place at a time
/// \param step the time between two places of a difference
/// \throws Error if the step is not positive and finite. The motion throws an `Error` if the step is
/// too short to change the time.
inline std::function<Solid_motion_3(double)>
motion_of_places(const std::function<Solid_place_3(double)>& place_at, double step) {
  if (!(step > 0) || !std::isfinite(step))
    throw Error("the step of the differences of a motion is not positive and finite: use a "
                "positive, finite number");
  return [place_at, step](double t) {
    const double first = t < step ? t : t - step, middle = t < step ? t + step : t,
                 last = middle + step;
    if (!(first < middle && middle < last))
      throw Error("the step of the differences of a motion is too short to change the time: use a "
                  "longer one");
    const Solid_place_3 a = place_at(first), b = place_at(middle), c = place_at(last),
                        &now = t < step ? a : b;
    const auto rate = [&](const auto& to_middle, const auto& to_last) {
      return t < step ? (4 * to_middle - to_last) / (last - first) : to_last / (last - first);
    };
    return Solid_motion_3{now.displacement, now.rotation,
                          rate(b.displacement - a.displacement, c.displacement - a.displacement),
                          rate(internal::rotation_from_to(a.rotation, b.rotation),
                               internal::rotation_from_to(a.rotation, c.rotation))};
  };
}

/// \ingroup PkgIncompressibleFluids3Ref
/// A solid whose motion is a function of time. Copies can be used by several threads if the
/// function can be.
/// \cgalModels{Solid_3}
/// \tparam Solid a model of `Solid_3`
template <class Solid> class Moving_solid_3
{
public:
  using Point = Epick::Point_3;   ///< a point in space
  using Vector = Epick::Vector_3; ///< a vector in space
  /// A function that returns the motion at a time. Its velocities must be the derivatives of its
  /// places, see `motion_of_places()`. The motion of the last time is stored, so the function is
  /// usually called once for each time and not for each point.
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
  /// \throws Error if the motion is not finite
  void walls(const Point& p, double t, std::vector<Wall_3>& result) const {
    const Solid_motion_3 motion = m_motion(t);
    for (const Vector& v :
         {motion.displacement, motion.rotation, motion.velocity, motion.angular_velocity})
      internal::require_place(v, "motion");
    const std::size_t first = result.size();
    const Vector from_center = p - (m_center + motion.displacement);
    const Eigen::Quaterniond rotation = internal::rotation_by(motion.rotation);
    m_solid.walls(m_center + turned(from_center, rotation.conjugate()), t, result);
    for (std::size_t i = first; i < result.size(); ++i) {
      Wall_3& wall = result[i];
      wall.normal = turned(wall.normal, rotation);
      wall.velocity =
          turned(wall.velocity, rotation) + motion.velocity +
          cross_product(motion.angular_velocity, from_center - wall.distance * wall.normal);
    }
  }

private:
  static Vector turned(const Vector& v, const Eigen::Quaterniond& rotation) {
    return internal::from_eigen<Vector>(rotation * internal::eigen_vector(v));
  }

  Solid m_solid;
  Point m_center;
  internal::Last_motion m_motion;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_MOVING_SOLID_3_H
