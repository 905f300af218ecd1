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
#include <functional>
#include <utility>

namespace dsc_python {

/// The places of a solid that a Python function gives: `function(t)` returns the displacement and
/// the rotation, with three coordinates each. Several threads can use it.
class Place_function
{
public:
  using Place = CGAL::Deformable_simplicial_complexes::Solid_place_3;

  explicit Place_function(py::function function) : m_function(std::move(function)) {}

  Place operator()(double t) const {
    using CGAL::Deformable_simplicial_complexes::point_of;
    const py::gil_scoped_acquire lock;
    const auto vectors = m_function(t).cast<std::array<std::array<double, 3>, 2>>();
    return {point_of<Place::Vector>(vectors[0]), point_of<Place::Vector>(vectors[1])};
  }

private:
  Shared_function m_function;
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
    if (const py::object given = rest.take("motion"); !given.is_none()) {
      const auto [function, step] = given.cast<std::pair<py::function, double>>();
      motion =
          CGAL::Deformable_simplicial_complexes::motion_of_places(Place_function(function), step);
    }
    rest.require_all_read();
  }

  /// Returns whether the solid has a constant velocity other than 0.
  bool has_velocity() const {
    return velocity != std::array<double, 3>() || angular_velocity != std::array<double, 3>();
  }

  CGAL::Deformable_simplicial_complexes::Wall_behavior wall;
  std::array<double, 3> velocity = {};         ///< of a body, the initial velocity
  std::array<double, 3> angular_velocity = {}; ///< of a body, the initial angular velocity
  /// A motion as a function of time; empty without one.
  std::function<CGAL::Deformable_simplicial_complexes::Solid_motion_3(double)> motion;
};

} // namespace dsc_python

#endif // DSC_PYTHON_SOLID_OPTIONS_H
