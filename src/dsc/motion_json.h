// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_MOTION_JSON_H
#define DSC_MOTION_JSON_H

#include "motion.h"
#include "report_json.h"

namespace dsc {

/// The subcommand and its own options.
Json motion_json(const Motion& motion);

/// The inverse. \throws Json::exception or std::out_of_range if there is no motion in `json`
Motion motion_from_json(const Json& json);

} // namespace dsc

#endif // DSC_MOTION_JSON_H
