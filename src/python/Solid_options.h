// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_PYTHON_SOLID_OPTIONS_H
#define DSC_PYTHON_SOLID_OPTIONS_H

#include "callbacks.h"
#include "options.h"

#include <CGAL/Deformable_simplicial_complexes/coordinates.h>
#include <CGAL/Incompressible_fluids_3/Fluid_state.h>
#include <CGAL/Incompressible_fluids_3/Moving_solid_3.h>

#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

namespace dsc_python {

/// Motion of a solid that a Python function gives: `function(t)` returns the displacement, the
/// rotation, the velocity and the angular velocity, with three coordinates each. Copies share the
/// motion at the last time. Several threads can use them.
class Motion_function
{
public:
  using Motion = CGAL::Deformable_simplicial_complexes::Solid_motion_3;

  explicit Motion_function(py::function function)
      : m_function(std::move(function)), m_last(std::make_shared<Last>()) {}

  Motion operator()(double t) const {
    {
      const std::lock_guard<std::mutex> lock(m_last->mutex);
      if (m_last->time == t)
        return m_last->motion;
    }
    const Motion result = motion(t); // without the mutex: the function may use the fluid
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
    Motion motion;
  };

  Motion motion(double t) const {
    using CGAL::Deformable_simplicial_complexes::point_of;
    using Vector = Motion::Vector;
    const py::gil_scoped_acquire lock;
    const auto vectors = m_function(t).cast<std::array<std::array<double, 3>, 4>>();
    return {point_of<Vector>(vectors[0]), point_of<Vector>(vectors[1]),
            point_of<Vector>(vectors[2]), point_of<Vector>(vectors[3])};
  }

  Shared_function m_function;
  std::shared_ptr<Last> m_last;
};

/// The options of all solids of a fluid. Vectors have three coordinates in the plane, too.
struct Solid_options
{
  /// \throws py::type_error if an option is unknown or of another type
  explicit Solid_options(const py::dict& options) {
    Options rest(options);
    rest.read("contact_angle", wall.contact_angle);
    rest.read("no_slip", wall.sticks);
    rest.read("separates", wall.separates);
    rest.read("velocity", velocity);
    rest.read("angular_velocity", angular_velocity);
    const py::object function = rest.take("motion");
    if (!function.is_none())
      motion.emplace(function.cast<py::function>());
    rest.require_all_read();
  }

  /// Returns whether the solid has a constant velocity other than 0.
  bool has_velocity() const {
    return velocity != std::array<double, 3>() || angular_velocity != std::array<double, 3>();
  }

  CGAL::Deformable_simplicial_complexes::Wall_behavior wall;
  std::array<double, 3> velocity = {};         ///< of a body, the initial velocity
  std::array<double, 3> angular_velocity = {}; ///< of a body, the initial angular velocity
  std::optional<Motion_function> motion;
};

} // namespace dsc_python

#endif // DSC_PYTHON_SOLID_OPTIONS_H
