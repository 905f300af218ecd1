// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_RUN_COMMAND_H
#define DSC_RUN_COMMAND_H

#include "commands/start_options.h"
#include "motions/run.h"
#include "programs/threads_option.h"

#include <CLI/CLI.hpp>

#include <string>

namespace dsc {

/// The options for the improvement of the interface before each step.
struct Interface_improvement_options
{
  bool improves_interface = false;
  std::string aggressiveness; ///< as written
};

/// The options of all commands that move an interface.
struct Run_command_options
{
  const Inputs* inputs = nullptr; ///< of the program
  std::string resume;             ///< checkpoint file
  unsigned steps = 10;
  Start_options start;
  Interface_improvement_options improvement;
  std::string largest_displacement; ///< as written
  unsigned threads = default_number_of_threads();
  Output_options output;
};

void add_improvement_options(CLI::App& command, Interface_improvement_options& options);
void add_output_options(CLI::App& command, Output_options& options);

/// Adds a command that moves an interface, with the common options of these commands.
CLI::App* add_run_command(CLI::App& app, const Inputs& inputs, const std::string& name,
                          const std::string& description, Run_command_options& options);

/// Returns the options that need no parsing, and the names of the given options.
Run_options begin_run_options(const CLI::App& command, const Run_command_options& options);

/// Reads and checks the options of a run whose motion is set.
/// \param check checks the conditions of the command
/// \throws Usage_error
void complete_run_options(const Run_command_options& options, const Default_start& defaults,
                          const Start_check& check, Run_options& run);

} // namespace dsc

#endif // DSC_RUN_COMMAND_H
