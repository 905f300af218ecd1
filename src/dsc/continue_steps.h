// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_CONTINUE_STEPS_H
#define DSC_CONTINUE_STEPS_H

#include "motion.h"

#include <set>
#include <string>

namespace dsc {

/// Makes sure that a motion has all options it cannot do without, and that they fit together.
/// \param given the names of the options that the motion was made of
/// \throws Usage_error
void require_options(const Motion& motion, const std::set<std::string>& given);

/// Makes sure that no option of the steps is given that another one makes useless.
/// \throws Usage_error
void require_effect_of_options(const Step_options& step, const std::set<std::string>& given);

/// Completes what a command line says of the steps by what a run did in each step so far: an option
/// that is not given stays as it was. Another command begins another motion, with its own options.
/// \param given the names of the options in the command line
/// \param asked what they say; then all there is to know
/// \return in words, what is not as before; empty if everything is
/// \throws Usage_error if options are missing, or do not fit together
std::string continue_steps(const Step_options& before, const std::set<std::string>& given,
                           Step_options& asked);

} // namespace dsc

#endif // DSC_CONTINUE_STEPS_H
