// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_RUN_POSITION_H
#define DSC_RUN_POSITION_H

#include "options.h"

#include <string>

namespace dsc {

/// Where a run stands: what a checkpoint has to tell beside the complex.
struct Run_position
{
  unsigned step = 0;
  double time = 0;
  Run_start start;
};

/// The text that goes into a checkpoint: JSON with the position and the motion.
std::string to_metadata(const Run_position& position, const Motion& motion);

/// The position in such a text; the start if another program wrote the checkpoint.
Run_position from_metadata(const std::string& metadata);

} // namespace dsc

#endif // DSC_RUN_POSITION_H
