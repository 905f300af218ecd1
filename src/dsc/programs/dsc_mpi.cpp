// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The program of the commands that move an interface, if `mpirun` starts the program `dsc`. The
// complex is distributed among the processes, which run the same steps. Only the first process
// writes messages.

#include "../commands/commands.h"
#include "../errors.h"
#include "../program.h"
#include "../run.h"
#include "../start_complex.h"
#include "../tracked_distributed.h"
#include "mpi_processes.h"

#include <CGAL/Deformable_simplicial_complexes/IO/checkpoint.h>
#include <CGAL/Deformable_simplicial_complexes/IO/distributed_checkpoint.h>
#include <CGAL/Deformable_simplicial_complexes/Mpi_communicator.h>
#ifdef DSC_WITH_SCOTCH
#include <CGAL/Deformable_simplicial_complexes/Scotch_partitioner.h>
#endif

#include <mpi.h>

#include <exception>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

namespace {

DSC::Communicator* all_processes = nullptr;

/// Divides a complex among the processes again if their work differs.
void divide(dsc::Tracked_distributed::Distributed& complex) {
#ifdef DSC_WITH_SCOTCH
  complex.rebalance(DSC::Scotch_partitioner());
#else
  complex.rebalance();
#endif
}

/// Distributes a complex that `build()` returns on the first process. An error of the first process
/// is thrown there, and another one on the other processes.
template <class Build> std::unique_ptr<dsc::Tracked_complex> distributed(const Build& build) {
  std::unique_ptr<dsc::Tracked_complex> built;
  std::exception_ptr failure;
  if (all_processes->rank() == 0) {
    try {
      built = build();
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
  auto result = std::make_unique<dsc::Tracked_distributed>(*all_processes, divide);
  const auto* const whole = dynamic_cast<dsc::Tracked_complex_3*>(built.get());
  result->complex.distribute(whole != nullptr ? whole->complex : dsc::Tracked_complex_3::Complex());
  return result;
}

std::unique_ptr<dsc::Tracked_complex> start(const dsc::Run_options& options,
                                            dsc::Repairs& repairs) {
  return distributed([&] { return dsc::start_complex(options, repairs); });
}

/// Reads a checkpoint of several processes, or of one process.
std::unique_ptr<dsc::Tracked_complex> resume(const std::string& path, std::string& metadata) {
  std::error_code error;
  const bool is_of_one =
      std::filesystem::is_regular_file(path, error) && CGAL::IO::checkpoint_dimension(path) != 0;
  if (all_processes->reduced(DSC::Communicator::Operation::maximum, is_of_one ? 1 : 0) == 0) {
    auto result = std::make_unique<dsc::Tracked_distributed>(*all_processes, divide);
    metadata = CGAL::IO::read_checkpoint(path, result->complex);
    return result;
  }
  auto result = distributed([&] { return dsc::track_checkpoint(path, metadata); });
  const auto bytes = all_processes->all_gather({metadata.begin(), metadata.end()}).front();
  metadata.assign(bytes.begin(), bytes.end());
  return result;
}

} // namespace

int main(int argc, char** argv) {
  int threads = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &threads); // one thread calls MPI
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
