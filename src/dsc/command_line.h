// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_COMMAND_LINE_H
#define DSC_COMMAND_LINE_H

#include "options.h"

#include <optional>

namespace dsc {

/// Reads and checks the command line, but opens no file. Returns nothing if help was asked for and
/// has been printed. \throws Usage_error
std::optional<Options> parse_command_line(int argc, char** argv);

} // namespace dsc

#endif // DSC_COMMAND_LINE_H
