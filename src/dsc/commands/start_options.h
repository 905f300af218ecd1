// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_START_OPTIONS_H
#define DSC_START_OPTIONS_H

#include "motions/run.h"

#include <CLI/CLI.hpp>

#include <initializer_list>

namespace dsc {

/// The start of a command without start options.
struct Default_start
{
  std::optional<Ball> ball;     ///< surface used without INPUT
  bool fits_inputs = false;     ///< whether inputs are fitted into the ball
  Figure figure = Figure::none; ///< figure used in the plane without INPUT
  std::optional<std::array<double, 6>> domain_in_space, domain_in_plane;
};

/// A function that throws Usage_error if a command cannot start from its options.
using Start_check = void(const Run_options& options, bool is_planar);

/// Throws Usage_error if options that need a surface are given for a run in the plane.
void require_space(const Run_options& run, bool is_planar,
                   std::initializer_list<const char*> options);

/// Adds the positional option for the inputs.
CLI::Option* add_inputs(CLI::App& command, Run_start& start);

/// Adds the options of a new run. The option `resume` excludes them.
/// \param domain receives the option `--domain` as written
void add_start_options(CLI::App& command, Run_start& start, std::string& domain,
                       CLI::Option* resume);

/// Checks the start of a run, reads its domain, and sets the defaults.
/// \param domain the option `--domain` as written
/// \param check checks the conditions of the command; may be null
/// \throws Usage_error
void complete_start(const std::string& domain, const Default_start& defaults, Start_check* check,
                    Run_options& run);

/// Adds the option for the array of a .vtu file that contains the labels.
CLI::Option* add_labels_option(CLI::App& command, std::string& labels);

/// Adds the option for the labels of a gray image.
void add_threshold_option(CLI::App& command, std::string& thresholds);

/// Checks that `--labels` is given only for files with arrays.
/// \throws Usage_error
void require_file_with_arrays(const std::string& path, const std::string& labels);

} // namespace dsc

#endif // DSC_START_OPTIONS_H
