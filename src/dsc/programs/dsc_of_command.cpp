// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The program of one command, which the program `dsc` executes. DSC_ADD_COMMAND is the function
// that adds the command.

#include "commands/commands.h"
#include "programs/program.h"

int main(int argc, char** argv) { return dsc::run_program(argc, argv, dsc::DSC_ADD_COMMAND); }
