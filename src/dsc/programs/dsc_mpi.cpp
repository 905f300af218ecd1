// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The program of the commands that move an interface, if `mpirun` starts the program `dsc`. All
// processes hold the complex together and run the same steps. Only the first process writes
// messages.

#include "../commands/commands.h"
#include "../errors.h"
#include "../program.h"
#include "../run.h"
#include "../start_complex.h"
#include "../tracked_distributed.h"
#include "mpi_processes.h"

#include <CGAL/Deformable_simplicial_complexes/IO/distributed_checkpoint.h>
#include <CGAL/Deformable_simplicial_complexes/Mpi_communicator.h>

#include <mpi.h>

#include <exception>
#include <memory>
#include <string>
#include <utility>

namespace {

DSC::Communicator* all_processes = nullptr;

/// Builds the complex on the first process, and distributes it. An error of the first process is
/// thrown there, and another one on the other processes.
std::unique_ptr<dsc::Tracked_complex> start(const dsc::Run_options& options,
                                            dsc::Repairs& repairs) {
  std::unique_ptr<dsc::Tracked_complex> built;
  std::exception_ptr failure;
  if (all_processes->rank() == 0) {
    try {
      built = dsc::start_complex(options, repairs);
      if (built->dimension() == 2)
        throw dsc::Usage_error("complexes in the plane are not available on several processes; run "
                               "dsc without mpirun");
    } catch (...) {
      failure = std::current_exception();
    }
  }
  const bool has_failed =
      all_processes->reduced(DSC::Communicator::Operation::maximum, failure ? 1 : 0) != 0;
  if (failure)
    std::rethrow_exception(failure);
  if (has_failed)
    throw dsc::Input_error("the first process could not build the complex");
  auto result = std::make_unique<dsc::Tracked_distributed>(*all_processes);
  const auto* const whole = dynamic_cast<dsc::Tracked_complex_3*>(built.get());
  result->complex.distribute(whole != nullptr ? whole->complex : dsc::Tracked_complex_3::Complex());
  return result;
}

std::unique_ptr<dsc::Tracked_complex> resume(const std::string& path, std::string& metadata) {
  auto result = std::make_unique<dsc::Tracked_distributed>(*all_processes);
  metadata = CGAL::IO::read_checkpoint(path, result->complex);
  return result;
}

} // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  int code = 0;
  {
    dsc::Mpi_processes processes(true);
    DSC::Mpi_communicator communicator;
    all_processes = &communicator;
    dsc::share_complexes(start, resume);
    code = dsc::run_program(argc, argv, dsc::add_flows);
    processes.end(code);
  }
  MPI_Finalize();
  return code;
}
