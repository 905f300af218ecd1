// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLUID_PROCESSES_H
#define DSC_FLUID_PROCESSES_H

#include "programs/errors.h"

#include <CGAL/Incompressible_fluids_3/Saddle_point_solver.h>

// The processes that run a fluid together. The program `dsc-fluid` is one process.
// `dsc-fluid-petsc` is one or more processes, which run the same steps. Each of the two programs
// defines these functions.
namespace dsc {

/// Returns whether this process writes files and messages. It is the first of all processes.
bool is_first_process();

/// Returns the number of processes on this machine.
unsigned processes_of_machine();

/// Lets a solver use PETSc.
/// \throws Other_program if this program is not linked with PETSc
void use_petsc(DSC::Saddle_point_solver& solver);

} // namespace dsc

#endif // DSC_FLUID_PROCESSES_H
