// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_RUN_POSITION_H
#define DSC_RUN_POSITION_H

#include "motion.h"
#include "run_start.h"

#include <optional>
#include <string>

namespace dsc {

/// Where a run stands.
struct Run_position
{
  unsigned step = 0;
  double time = 0;
  Run_start start;
};

/// What a checkpoint has to tell beside the complex.
struct Saved_run
{
  Run_position position;
  Step_options step;
};

/// The text that goes into a checkpoint: JSON.
std::string to_metadata(const Run_position& position, const Step_options& step);

/// The run in such a text; nothing if another program wrote the checkpoint.
std::optional<Saved_run> from_metadata(const std::string& metadata);

} // namespace dsc

#endif // DSC_RUN_POSITION_H
