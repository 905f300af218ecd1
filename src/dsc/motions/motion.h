// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_MOTION_H
#define DSC_MOTION_H

#include "programs/option_values.h"

#include <CGAL/Interface_flows/Corner_rule.h>
#include <CGAL/Interface_flows/Integration_scheme.h>

#include <optional>
#include <variant>

namespace dsc {

/// A rotation about an axis through the center of the domain; in the plane, about the center.
struct Rotation
{
  std::array<double, 3> axis = {}; ///< of any length; zero in the plane
  double degrees = 0;              ///< per step
};

/// A motion along the outward normals.
struct Offset
{
  Distance distance = {};   ///< per step, positive outwards
  bool moves_faces = false; ///< whether faces move as a whole, instead of each vertex along its own
                            ///< normal
  DSC::Corner_rule corners = DSC::Corner_rule::miter;
};

/// A motion by a velocity field in the coordinates of the input.
struct Advection
{
  enum class Field { enright, vortex, expressions };

  Field field = Field::expressions;
  std::optional<double> period = std::nullopt; ///< T of the factor cos(pi t / T), if set
  double dt = 0;                ///< per step; 0 until it is chosen at the start of the run
  std::string expressions = ""; ///< in x, y, z and t, if `field` is `expressions`
  DSC::Integration_scheme scheme = DSC::Integration_scheme::rk4;
  std::optional<double> tolerance = std::nullopt; ///< in mean edges; the library's default if not
                                                  ///< set
};

/// A motion by the mean curvature.
struct Curvature_flow
{
  std::optional<double> dt; ///< per step, in squares of the unit of the input; the square of the
                            ///< mean interface edge of the input if not set
  bool keeps_volumes = false;
  std::optional<double> tolerance; ///< in mean edges; the library's default if not set
  /// The volumes of all labels at the start of the run, if they are kept.
  std::map<int, double> volumes = {};
};

/// A rotation about the point (50, 50) of the plane, one turn in 628 units of time.
struct Zalesak
{
  static constexpr double period = 628;

  double dt = 1; ///< per step
};

using Motion = std::variant<Rotation, Offset, Advection, Curvature_flow, Zalesak>;

/// Returns the length of a time step of a motion, in the time unit of the input.
/// \param edge mean interface edge of the input
inline double time_step(const Motion& motion, double edge) {
  if (const auto* zalesak = std::get_if<Zalesak>(&motion))
    return zalesak->dt;
  if (const auto* advection = std::get_if<Advection>(&motion))
    return advection->dt;
  const auto* flow = std::get_if<Curvature_flow>(&motion);
  return flow == nullptr ? 1 : flow->dt.value_or(edge * edge);
}

/// The options of each step of a run.
struct Step_options
{
  Motion motion;
  bool improves_interface = false;      ///< before the motion
  std::optional<double> aggressiveness; ///< of the improvement; default if not set
  bool grows_domain = false;            ///< when the interface comes near its boundary
  /// of a vertex in one deformation, in local edges; the default of the library if not set
  std::optional<double> largest_displacement;
};

/// Returns the integration schemes by their names in the command line, in files and in Python.
inline const std::map<std::string, DSC::Integration_scheme>& integration_schemes() {
  static const std::map<std::string, DSC::Integration_scheme> schemes = {
      {"euler", DSC::Integration_scheme::euler},
      {"rk2", DSC::Integration_scheme::rk2},
      {"rk4", DSC::Integration_scheme::rk4},
      {"adaptive", DSC::Integration_scheme::adaptive}};
  return schemes;
}

/// Returns the rules for corners of an offset by their names.
inline const std::map<std::string, DSC::Corner_rule>& corner_rules() {
  static const std::map<std::string, DSC::Corner_rule> rules = {{"miter", DSC::Corner_rule::miter},
                                                                {"round", DSC::Corner_rule::round}};
  return rules;
}

} // namespace dsc

#endif // DSC_MOTION_H
