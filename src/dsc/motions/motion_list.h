// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_MOTION_LIST_H
#define DSC_MOTION_LIST_H

#include "motions/motion.h"
#include "output/report_json.h"

#include <set>

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

/// Checks that all required options of a motion are given, and that its options are compatible.
/// \param given names of the options that define the motion
/// \throws Usage_error
void require_options(const Motion& motion, const std::set<std::string>& given);

/// Checks that no step option is given that another option makes useless.
/// \throws Usage_error
void require_effect_of_options(const Step_options& step, const std::set<std::string>& given);

/// Completes the step options of a command line by the options of the previous run: an option that
/// is not given keeps its value. Another command starts another motion, with its own options.
/// \param given names of the options in the command line
/// \param asked the options of the command line; replaced by the complete options
/// \return a text that lists the differences to the previous run; empty if there are none
/// \throws Usage_error if options are missing or incompatible
std::string continue_steps(const Step_options& before, const std::set<std::string>& given,
                           Step_options& asked);

} // namespace dsc

#endif // DSC_MOTION_LIST_H
