// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_COMMANDS_H
#define DSC_COMMANDS_H

#include "options.h"

namespace dsc {

/// The subcommands. Each returns the exit code of the program and throws std::runtime_error, with
/// a message of one line that says what is wrong and what to do.
int execute(const Run_options& options);
int execute(const Info_options& options);
int execute(const Convert_options& options);
int execute(const Improve_options& options);
int execute(const Cut_locus_options& options);
int execute(const Reconstruct_options& options);
/// Computes the flow of the liquids of a scene.
int execute(const Fluid_options& options);

} // namespace dsc

#endif // DSC_COMMANDS_H
