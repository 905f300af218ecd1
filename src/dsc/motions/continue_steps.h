// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_CONTINUE_STEPS_H
#define DSC_CONTINUE_STEPS_H

#include "motions/motion.h"

#include <set>
#include <string>

namespace dsc {

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

#endif // DSC_CONTINUE_STEPS_H
