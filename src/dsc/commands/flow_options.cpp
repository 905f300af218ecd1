// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/flow_options.h"

#include "option_values.h"

namespace dsc {
namespace {

constexpr double default_dt = .01;

} // namespace

void add_tolerance_option(CLI::App& command, Tolerance_option& option) {
  command.add_option("--tolerance", option.tolerance,
                     "How far edges may lie from the smooth interface where it gets too coarse for "
                     "its curvature, in mean edges of the input; 0.04 in space and 0.005 in the "
                     "plane if not given; with 0, the interface is not "
                     "adapted to its curvature");
}

void add_flow_options(CLI::App& command, Flow_options& options) {
  command.add_option("--period", options.period,
                     "Multiply velocities by cos(pi t / PERIOD), so that all is back after it");
  command.add_option("--dt", options.dt,
                     "Time per step; 0.01 if not given. The distance to the start is reported "
                     "where a step ends with a period");
  command.add_option("--scheme", options.scheme, "How velocities are integrated")
      ->check(CLI::IsMember(&integration_schemes()))
      ->capture_default_str();
  add_tolerance_option(command, options.tolerance);
}

std::optional<double> read_tolerance(const Tolerance_option& option,
                                     const std::set<std::string>& given) {
  return given.count("--tolerance") > 0 ? std::make_optional(parse_tolerance(option.tolerance))
                                        : std::nullopt;
}

Advection read_flow(const Flow_options& options, Advection::Field field,
                    const std::string& expressions, double default_period,
                    const std::set<std::string>& given) {
  return {field,
          expressions,
          given.count("--period") > 0 ? parse_positive(options.period, "--period") : default_period,
          given.count("--dt") > 0 ? parse_positive(options.dt, "--dt") : default_dt,
          integration_schemes().at(options.scheme),
          read_tolerance(options.tolerance, given)};
}

} // namespace dsc
