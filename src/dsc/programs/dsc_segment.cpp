// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The program of the command `dsc segment`, which the program `dsc` executes.

#include "commands/commands.h"
#include "programs/program.h"

int main(int argc, char** argv) { return dsc::run_program(argc, argv, dsc::add_segment); }
