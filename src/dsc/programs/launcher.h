// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_LAUNCHER_H
#define DSC_LAUNCHER_H

#include <cstdlib>
#include <iostream>
#include <string>

namespace dsc {

/// The processes that a launcher such as `mpirun` started together with this one.
struct Launch
{
  std::string variable; ///< of the environment that states their number; empty without a launcher
  int processes = 1;
  int rank = 0; ///< of this process
};

/// Returns what the environment tells about the launcher.
inline Launch launch() {
  // variables of Open MPI, of MPICH and its relatives, and of Slurm
  static constexpr const char* launchers[][2] = {{"OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK"},
                                                 {"PMI_SIZE", "PMI_RANK"},
                                                 {"SLURM_STEP_NUM_TASKS", "SLURM_PROCID"}};
  for (const auto& [size, rank] : launchers)
    if (const char* const number = std::getenv(size)) {
      const char* const own = std::getenv(rank);
      return {size, std::atoi(number), own != nullptr ? std::atoi(own) : 0};
    }
  return {};
}

/// Returns whether `mpirun` or a batch system started this process as one of several ranks of MPI,
/// or as a single one.
inline bool is_started_by_mpi() {
  const Launch launched = launch(); // Slurm also starts single processes that do not use MPI
  return launched.processes > 1 || launched.variable.find("_SIZE") != std::string::npos ||
         std::getenv("PMIX_RANK") != nullptr;
}

/// Suppresses the error messages of all launched processes except the first one, if all of them
/// have the same error.
inline void leave_messages_to_first_process() {
  if (launch().rank > 0)
    std::cerr.setstate(std::ios::failbit);
}

} // namespace dsc

#endif // DSC_LAUNCHER_H
