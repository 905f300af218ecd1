// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/flow_options.h"

#include "programs/option_values.h"

namespace dsc {
namespace {

constexpr double default_dt = .01; // of the flows with given velocities

} // namespace

void add_tolerance_option(CLI::App& command, Tolerance_option& option) {
  command.add_option(
      "--tolerance", option.tolerance,
      "Tolerance of interface edges to the smooth interface, in mean edges of the input "
      "(default: 0.04, in the plane 0.005); 0 turns off the adaptation of the "
      "interface to its curvature");
}

void add_flow_options(CLI::App& command, Flow_options& options) {
  command.add_option(
      "--period", options.period,
      "Multiply velocities by cos(pi t / PERIOD), so that the interface returns after the "
      "period");
  command.add_option(
      "--dt", options.dt,
      "Time step (default: the fastest vertex moves by a mean edge at the start; for "
      "enright and vortex 0.01). The report contains the distance to the initial "
      "interface for each step that ends with a period");
  command.add_option("--scheme", options.scheme, "Integration scheme")
      ->check(CLI::IsMember(&integration_schemes()))
      ->capture_default_str();
  add_tolerance_option(command, options.tolerance);
}

std::optional<double> read_tolerance(const Tolerance_option& option,
                                     const std::set<std::string>& given) {
  return given.count("--tolerance") > 0
             ? std::make_optional(parse_not_negative(option.tolerance, "--tolerance", "0.04"))
             : std::nullopt;
}

Advection read_flow(const Flow_options& options, Advection::Field field,
                    const std::string& expressions, double default_period,
                    const std::set<std::string>& given) {
  return {field,
          expressions,
          given.count("--period") > 0 ? parse_positive(options.period, "--period") : default_period,
          given.count("--dt") > 0                  ? parse_positive(options.dt, "--dt")
          : field == Advection::Field::expressions ? 0
                                                   : default_dt,
          integration_schemes().at(options.scheme),
          read_tolerance(options.tolerance, given)};
}

} // namespace dsc
