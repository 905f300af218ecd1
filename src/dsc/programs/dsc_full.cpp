// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The program `dsc-full`, which the program `dsc` executes. It contains the flows of all inputs:
// also of curves, images and tetrahedra, and of surfaces that are repaired.

#include "commands/commands.h"
#include "input/Inputs.h"
#include "programs/program.h"

#include <CLI/CLI.hpp>

int main(int argc, char** argv) {
  const dsc::All_inputs inputs;
  return dsc::run_program(argc, argv, [&](CLI::App& app, int& exit_code) {
    dsc::add_info(app, exit_code);
    dsc::add_flows(app, inputs, exit_code);
    dsc::add_convert(app, inputs, exit_code);
    dsc::add_improve(app, exit_code);
  });
}
