// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_COMMAND_LINE_H
#define DSC_COMMAND_LINE_H

#include <CLI/CLI.hpp>

namespace dsc {

/// Reads the command line and runs its command, a subcommand of `app`. Prints the help if
/// requested.
/// \throws Usage_error if the command line is invalid; also throws the exceptions of the command
void run_command_line(CLI::App& app, int argc, char** argv);

} // namespace dsc

#endif // DSC_COMMAND_LINE_H
