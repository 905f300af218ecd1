// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_RUN_COMMAND_H
#define DSC_RUN_COMMAND_H

#include "commands/start_options.h"
#include "motions/motion.h"

#include <CLI/CLI.hpp>

namespace dsc {

class Inputs;

/// Adds the command of a motion, with the options of all commands that move an interface.
/// \param motion with the default values of its options
/// \param check checks the conditions of the command; may be null
/// \param exit_code receives the exit code of a run
void add_run_command(CLI::App& app, const Inputs& inputs, const char* description,
                     const Motion& motion, const Default_start& start, Start_check* check,
                     int& exit_code);

} // namespace dsc

#endif // DSC_RUN_COMMAND_H
