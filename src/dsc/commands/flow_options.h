// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLOW_OPTIONS_H
#define DSC_FLOW_OPTIONS_H

#include "motions/motion.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <set>
#include <string>

namespace dsc {

/// The option for the adaptation of an interface to its curvature.
struct Tolerance_option
{
  std::string tolerance; ///< as written
};

/// The options of a flow by a velocity field.
struct Flow_options
{
  std::string period, dt; ///< as written
  std::string scheme = "rk4";
  Tolerance_option tolerance;
};

void add_tolerance_option(CLI::App& command, Tolerance_option& option);
void add_flow_options(CLI::App& command, Flow_options& options);

/// Returns the tolerance; `nullopt` if it is not given.
/// \param given names of the options in the command line
/// \throws Usage_error
std::optional<double> read_tolerance(const Tolerance_option& option,
                                     const std::set<std::string>& given);

/// Returns the flow described by the options.
/// \throws Usage_error
Advection read_flow(const Flow_options& options, Advection::Field field,
                    const std::string& expressions, double default_period,
                    const std::set<std::string>& given);

} // namespace dsc

#endif // DSC_FLOW_OPTIONS_H
