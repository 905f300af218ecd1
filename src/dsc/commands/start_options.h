// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_START_OPTIONS_H
#define DSC_START_OPTIONS_H

#include "run.h"

#include <CLI/CLI.hpp>

#include <array>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>

namespace dsc {

/// The options that say where a run starts.
struct Start_options
{
  Run_start start;
  std::string domain, edge, largest_hole; ///< as they are written
};

/// Where a command starts if the command line does not say it.
struct Default_start
{
  std::optional<Ball> ball;     ///< the surface without INPUT
  bool fits_inputs = false;     ///< into that ball
  Figure figure = Figure::none; ///< in the plane, without INPUT
  std::optional<std::array<double, 6>> domain_in_space, domain_in_plane;
};

/// Throws Usage_error if a command cannot start from what its options say.
using Start_check = std::function<void(const Run_options& options, bool is_planar)>;

/// Throws Usage_error if a run in the plane is given one of the options that need a surface.
void require_space(const Run_options& run, bool is_planar,
                   std::initializer_list<const char*> options);

/// Adds the positional option for the inputs.
CLI::Option* add_inputs(CLI::App& command, Start_options& options);

/// Adds the options of a new run; `resume` excludes them.
void add_start_options(CLI::App& command, Start_options& options, CLI::Option* resume);

/// Sets the default figure, and returns whether a new run starts in the plane.
bool set_default_figure(Run_options& run, const Default_start& defaults);

/// Reads the option `--domain`. \throws Usage_error
void read_domain(const Start_options& options, bool is_planar, Run_options& run);

/// Checks the start of a run, reads the remaining options, and sets the defaults.
/// \param check the conditions of the command itself
/// \throws Usage_error
void complete_start(const Start_options& options, const Default_start& defaults, bool is_planar,
                    const Start_check& check, Run_options& run);

} // namespace dsc

#endif // DSC_START_OPTIONS_H
