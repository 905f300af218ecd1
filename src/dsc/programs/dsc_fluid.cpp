// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The program of the command `dsc fluid`, which the program `dsc` executes. The program
// `dsc-fluid-petsc` contains the solver of PETSc, so that this program does not need PETSc.

#include "commands/commands.h"
#include "fluids/fluid_processes.h"
#include "input/files.h"
#include "input/translations.h"
#include "programs/launcher.h"
#include "programs/program.h"

#include <CLI/CLI.hpp>

namespace {

[[noreturn]] void leave_to_petsc() {
  static constexpr char name[] = "dsc-fluid-petsc";
  if (dsc::exists(dsc::path_of_program(name)))
    throw dsc::Other_program{name, "the option --solver petsc"};
  dsc::leave_messages_to_first_process();
  throw std::runtime_error("--solver petsc and mpirun need the program dsc-fluid-petsc; build it "
                           "with the CMake option -DDSC_WITH_PETSC=ON (Debian: petsc-dev), or "
                           "leave them out");
}

/// Returns whether the arguments choose PETSc. This program cannot read options of PETSc.
bool choose_petsc(const std::vector<std::string>& arguments) {
  for (std::size_t i = 0; i < arguments.size(); ++i)
    if (arguments[i] == "--solver=petsc" ||
        (arguments[i] == "--solver" && i + 1 < arguments.size() && arguments[i + 1] == "petsc"))
      return true;
  return false;
}

} // namespace

bool dsc::is_first_process() { return true; }

unsigned dsc::processes_of_machine() { return 1; }

void dsc::use_petsc(DSC::Saddle_point_solver&) { leave_to_petsc(); }

int main(int argc, char** argv) {
  return dsc::run_program(argc, argv, [&](CLI::App& app, int& exit_code) {
    // Without PETSc, all processes would write the same files.
    if (choose_petsc({argv, argv + argc}) || dsc::is_started_by_mpi())
      leave_to_petsc();
    dsc::add_fluid(app, exit_code);
  });
}
