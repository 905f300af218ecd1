// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/commands.h"

namespace dsc {

void add_flows(CLI::App& app, const Inputs& inputs, int& exit_code) {
  add_rotate(app, inputs, exit_code);
  add_offset(app, inputs, exit_code);
  add_enright(app, inputs, exit_code);
  add_vortex(app, inputs, exit_code);
  add_advect(app, inputs, exit_code);
  add_mean_curvature(app, inputs, exit_code);
  add_zalesak(app, inputs, exit_code);
}

} // namespace dsc
