// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/commands.h"

namespace dsc {

void add_flows(CLI::App& app, int& exit_code) {
  add_rotate(app, exit_code);
  add_offset(app, exit_code);
  add_enright(app, exit_code);
  add_vortex(app, exit_code);
  add_advect(app, exit_code);
  add_mean_curvature(app, exit_code);
  add_zalesak(app, exit_code);
}

} // namespace dsc
