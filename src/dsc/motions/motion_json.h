// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_MOTION_JSON_H
#define DSC_MOTION_JSON_H

#include "motions/motion.h"
#include "output/report_json.h"

namespace dsc {

/// Returns the subcommand and its own options.
Json motion_json(const Motion& motion);

/// Returns the motion stored by motion_json().
/// \throws Json::exception or std::out_of_range if `json` contains no motion
Motion motion_from_json(const Json& json);

} // namespace dsc

#endif // DSC_MOTION_JSON_H
