// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_FLOWS_INTERNAL_PATHS_INTERFACE_PATHS_H
#define CGAL_INTERFACE_FLOWS_INTERNAL_PATHS_INTERFACE_PATHS_H

#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/internal/destinations/Destinations.h>
#include <CGAL/Interface_flows/Integration_scheme.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/coordinates.h>
#include <CGAL/Origin.h>
#include <CGAL/tags.h>

#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include <type_traits>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The forms of velocities that `advect_interface()` accepts. If several forms fit, the order is:
// flow map, interface step, velocity field, interface velocity.
template <class Complex, class Velocity, class Point = typename Complex::Point>
constexpr bool is_flow_map = std::is_invocable_v<const Velocity&, Point, double, double>;
template <class Complex, class Velocity, class Point = typename Complex::Point>
constexpr bool is_interface_step =
    std::is_invocable_v<const Velocity&, const Interface_snapshot<Complex>&,
                        const std::vector<Point>&, double, double, std::vector<Point>&>;

// Tells whether a velocity is a model of `VelocityFieldOfPoints`. The form is not tested for flow
// maps, because generic function objects of three arguments may not compile with others.
template <class Complex, class Velocity, class Point = typename Complex::Point,
          class Vector = typename Complex::Vector>
constexpr bool is_field_of_points = std::conjunction_v<
    std::bool_constant<!is_flow_map<Complex, Velocity>>,
    std::is_invocable<const Velocity&, const std::vector<Point>&, double, std::vector<Vector>&>>;

// Tells whether a flow map defines the type `Is_invertible` as `Tag_true`.
template <class Map, class = void> struct Is_invertible : Tag_false
{
};
template <class Map>
struct Is_invertible<Map, std::void_t<typename Map::Is_invertible>> : Map::Is_invertible
{
};

template <class Complex, class Velocity, class Point = typename Complex::Point>
constexpr bool is_velocity_field =
    !is_flow_map<Complex, Velocity> && !is_interface_step<Complex, Velocity> &&
    (is_field_of_points<Complex, Velocity> || std::is_invocable_v<const Velocity&, Point, double>);

// Tells whether free vertices move with a velocity. This holds for fields and for flow maps that
// are invertible.
template <class Complex, class Velocity>
constexpr bool is_flow_of_space = is_velocity_field<Complex, Velocity> ||
                                  (is_flow_map<Complex, Velocity> &&
                                   Is_invertible<Velocity>::value);

// Tells whether a velocity has one of the forms that `advect_interface()` accepts, with results of
// the right types.
template <class Complex, class Velocity> constexpr bool is_velocity() {
  using Point = typename Complex::Point;
  using Vector = typename Complex::Vector;
  if constexpr (is_flow_map<Complex, Velocity>)
    return std::is_invocable_r_v<Point, const Velocity&, Point, double, double>;
  else if constexpr (is_interface_step<Complex, Velocity> || is_field_of_points<Complex, Velocity>)
    return true;
  else if constexpr (is_velocity_field<Complex, Velocity>)
    return std::is_invocable_r_v<Vector, const Velocity&, Point, double>;
  else
    return std::is_invocable_v<const Velocity&, const Interface_snapshot<Complex>&,
                               const std::vector<Point>&, double, std::vector<Vector>&>;
}

// Returns the same, and does not compile if it is false.
template <class Complex, class Velocity> constexpr bool require_velocity() {
  static_assert(
      is_velocity<Complex, Velocity>(),
      "the velocity models none of VelocityField, VelocityFieldOfPoints, InterfaceFlowMap, "
      "InterfaceVelocity and InterfaceStep: compare its operator() with these concepts");
  return is_velocity<Complex, Velocity>();
}

// The type of the interface that a velocity needs: vertices only for fields and flow maps, vertices
// and facets for the other forms.
template <class Complex, class Velocity>
using Interface_seen_by =
    std::conditional_t<is_velocity_field<Complex, Velocity> || is_flow_map<Complex, Velocity>,
                       Interface_vertices<Complex>, Interface_snapshot<Complex>>;

// Returns the velocities of a field at points. On a torus, the field is evaluated at points of the
// box. Throws Invalid_destination_error if their number is wrong.
template <class Complex, class Velocity>
std::vector<typename Complex::Vector> field_at(const typename Complex::Domain& domain,
                                               const std::vector<typename Complex::Point>& points,
                                               double t, const Velocity& velocity) {
  std::vector<typename Complex::Vector> result;
  if constexpr (is_field_of_points<Complex, Velocity>) {
    if (points.empty())
      return result;
    std::vector<typename Complex::Point> in_box;
    for (const auto& p : points)
      in_box.push_back(domain.canonical(p));
    velocity(in_box, t, result);
    if (result.size() != points.size())
      throw Invalid_destination_error("the number of velocities differs from the number of points: "
                                      "give one velocity for each point",
                                      {});
  } else {
    for (const auto& p : points)
      result.push_back(velocity(domain.canonical(p), t));
  }
  return result;
}

// Returns the velocities of all vertices of an interface at the given positions. The velocity is a
// field or an interface velocity. Throws Invalid_destination_error if a velocity is not finite or
// their number is wrong.
template <class Interface, class Velocity>
std::vector<typename Interface::Complex::Vector>
velocities_at(const Interface& interface_,
              const std::vector<typename Interface::Complex::Point>& positions, double t,
              const Velocity& velocity) {
  using Complex = typename Interface::Complex;
  std::vector<typename Complex::Vector> result;
  if constexpr (is_velocity_field<Complex, Velocity>) {
    result = field_at<Complex>(interface_.domain, positions, t, velocity);
  } else {
    velocity(interface_, positions, t, result);
    if (result.size() != positions.size())
      throw Invalid_destination_error("the number of velocities differs from the number of "
                                      "interface vertices: give one velocity for each vertex",
                                      {});
  }
  require_finite(result, "a velocity");
  return result;
}

// The shortest substep of adaptive integration, as a part of the time step. This limits the number
// of substeps to a million. Without a limit, the integration of a field with unbounded derivatives
// would not end.
constexpr double smallest_adaptive_part = 1e-6;

// Returns the end points of the paths of all vertices, by the method of Dormand and Prince. The
// estimated error of each substep is at most the tolerance, a length. Throws Error if the substeps
// become too short.
template <class Interface, class Velocity>
std::vector<typename Interface::Complex::Point>
integrate_adaptively(const Interface& interface_,
                     const std::vector<typename Interface::Complex::Point>& start,
                     const Velocity& velocity, double t, double dt, double tolerance) {
  using Complex = typename Interface::Complex;
  namespace odeint = boost::numeric::odeint;
  using State = std::vector<double>; // coordinates of all vertices
  using Points = std::vector<typename Complex::Point>;
  static constexpr int d = Complex::dimension;
  const auto points = [](const State& state) {
    Points result;
    for (std::size_t i = 0; i < state.size(); i += d) {
      std::array<double, d> coordinates;
      std::copy_n(state.begin() + std::ptrdiff_t(i), d, coordinates.begin());
      result.push_back(point_at<Complex>(coordinates));
    }
    return result;
  };
  State state;
  for (const auto& p : start)
    for (int i = 0; i < d; ++i)
      state.push_back(p[i]);
  const auto derivative = [&](const State& x, State& derivatives, double time) {
    double* out = derivatives.data();
    for (const auto& v : velocities_at(interface_, points(x), time, velocity))
      for (int i = 0; i < d; ++i)
        *out++ = v[i];
  };
  auto stepper = odeint::make_controlled(tolerance, 0., odeint::runge_kutta_dopri5<State>());
  const double end = t + dt;
  if (!std::isfinite(t) || !std::isfinite(dt))
    throw Error("the time or the time step is not finite: use finite numbers");
  if (end == t && dt != 0)
    throw Error("the time step is too short to change the time: use a longer time step, or "
                "subtract a constant from the time");
  // Adding a short substep to a large time may leave the time unchanged.
  const auto is_long_enough = [&](double step) {
    return std::abs(step) >= smallest_adaptive_part * std::abs(dt) && t + step != t;
  };
  for (double step = dt;;) {
    Progress_scope::check();
    const bool is_last = std::abs(step) >= std::abs(end - t);
    if (is_last)
      step = end - t;
    else if (!is_long_enough(step))
      throw Error("the velocities change too fast for the integration tolerance: use a larger "
                  "tolerance, or a shorter time step");
    try {
      if (stepper.try_step(derivative, state, t, step) == odeint::success && is_last)
        break;
    } catch (const Invalid_destination_error&) { // a shorter substep may stay finite
      step /= 2;
      if (!is_long_enough(step))
        throw;
    }
  }
  return points(state);
}

// Returns the place of a point, or of all vertices, after one step of an explicit Runge-Kutta
// method. `rate(place, time)` returns the velocity, `advance(place, rate, step)` the new place.
template <class Place, class Rate, class Advance>
Place follow_rate(const Place& start, double t, double dt, Integration_scheme scheme,
                  const Rate& rate, const Advance& advance) {
  const auto k1 = rate(start, t);
  if (scheme == Integration_scheme::euler)
    return advance(start, k1, dt);
  const auto k2 = rate(advance(start, k1, dt / 2), t + dt / 2);
  if (scheme == Integration_scheme::rk2)
    return advance(start, k2, dt);
  const auto k3 = rate(advance(start, k2, dt / 2), t + dt / 2);
  const auto k4 = rate(advance(start, k3, dt), t + dt);
  const Place halfway = advance(advance(start, k1, dt / 6), k2, dt / 3);
  return advance(advance(halfway, k3, dt / 3), k4, dt / 6);
}

// Returns points moved by `step` times their velocities.
template <class Complex>
std::vector<typename Complex::Point>
advanced(std::vector<typename Complex::Point> points,
         const std::vector<typename Complex::Vector>& velocities, double step) {
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i] = points[i] + step * velocities[i];
  return points;
}

// Returns the end points of the paths of all vertices, by one step of an explicit Runge-Kutta
// method.
template <class Interface, class Velocity>
std::vector<typename Interface::Complex::Point> integrate_with_fixed_steps(
    const Interface& interface_, const std::vector<typename Interface::Complex::Point>& start,
    const Velocity& velocity, double t, double dt, Integration_scheme scheme) {
  using Complex = typename Interface::Complex;
  using Points = std::vector<typename Complex::Point>;
  const auto rate = [&](const Points& positions, double time) {
    return velocities_at(interface_, positions, time, velocity);
  };
  return follow_rate(start, t, dt, scheme, rate, advanced<Complex>);
}

// Returns the positions at t + dt of the points that are at given positions at t. The result only
// guides free vertices, so `Integration_scheme::rk4` is used for fields. A position is not finite
// where a velocity is not finite. \pre is_flow_of_space
template <class Complex, class Velocity>
std::vector<typename Complex::Point> follow_flow(const typename Complex::Domain& domain,
                                                 const std::vector<typename Complex::Point>& start,
                                                 const Velocity& velocity, double t, double dt) {
  using Points = std::vector<typename Complex::Point>;
  if constexpr (is_flow_map<Complex, Velocity>) {
    Points result;
    for (const auto& p : start)
      result.push_back(velocity(p, t, dt));
    return result;
  } else {
    const auto rate = [&](const Points& points, double time) {
      Points finite; // the field is not evaluated at other points
      for (const auto& p : points)
        if (has_finite_coordinates(p))
          finite.push_back(p);
      const auto velocities = field_at<Complex>(domain, finite, time, velocity);
      std::vector<typename Complex::Vector> result;
      auto next = velocities.begin();
      for (const auto& p : points)
        result.push_back(has_finite_coordinates(p) ? *next++ : p - ORIGIN);
      return result;
    };
    return follow_rate(start, t, dt, Integration_scheme::rk4, rate, advanced<Complex>);
  }
}

// Returns the positions of the vertices of an interface at t + dt, for each form of a velocity. If
// `error` is not null, it gets the error that an interface step estimates.
template <class Interface, class Velocity>
std::vector<typename Interface::Complex::Point>
find_destinations(const Interface& interface_,
                  const std::vector<typename Interface::Complex::Point>& start,
                  const Velocity& velocity, double t, double dt, Integration_scheme scheme,
                  double tolerance, double* error = nullptr) {
  using Complex = typename Interface::Complex;
  using Point = typename Complex::Point;
  if constexpr (is_flow_map<Complex, Velocity>) {
    std::vector<Point> result;
    for (const Point& p : start)
      result.push_back(velocity(p, t, dt));
    return result;
  } else if constexpr (is_interface_step<Complex, Velocity>) {
    std::vector<Point> result;
    if constexpr (std::is_same_v<decltype(velocity(interface_, start, t, dt, result)), double>) {
      const double estimate = velocity(interface_, start, t, dt, result);
      if (error)
        *error = estimate;
    } else {
      velocity(interface_, start, t, dt, result);
    }
    if (result.size() != start.size())
      throw Invalid_destination_error("the number of destinations differs from the number of "
                                      "interface vertices: give one destination for each vertex",
                                      {});
    return result;
  } else if (scheme == Integration_scheme::adaptive) {
    return integrate_adaptively(interface_, start, velocity, t, dt, tolerance);
  } else {
    return integrate_with_fixed_steps(interface_, start, velocity, t, dt, scheme);
  }
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INTERFACE_FLOWS_INTERNAL_PATHS_INTERFACE_PATHS_H
