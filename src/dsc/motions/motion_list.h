// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_MOTION_LIST_H
#define DSC_MOTION_LIST_H

#include "motions/motion.h"
#include "output/report_json.h"

#include <set>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace dsc {

/// Returns the name of the command of a motion.
std::string command_of(const Motion& motion);

/// Adds the options of a motion to its command. Options that are given replace its values.
void add_options(CLI::App& command, Motion& motion);

/// Returns the command and its own options.
Json motion_json(const Motion& motion);

/// Returns the motion stored by motion_json().
/// \throws Json::exception or std::out_of_range if `json` contains no motion
Motion motion_from_json(const Json& json);

/// Replaces each option that is not given by its value before. Returns the names of the given
/// options that differ from before. Both motions must have the same command.
std::vector<std::string> keep_options(const Step_options& before,
                                      const std::set<std::string>& given, Step_options& asked);

} // namespace dsc

#endif // DSC_MOTION_LIST_H
