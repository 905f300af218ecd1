// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The program of the commands that move an interface, if `mpirun` starts the program `dsc`. The
// complex is distributed among the processes, which run the same steps. Only the first process
// writes messages.

#include "commands/commands.h"
#include "input/Inputs.h"
#include "input/translations.h"
#include "motions/run.h"
#include "motions/run_position.h"
#include "motions/tracked_distributed.h"
#include "programs/errors.h"
#include "programs/mpi_processes.h"
#include "programs/program.h"

#include <CGAL/Distributed_complexes/Mpi_communicator.h>
#include <CGAL/Distributed_complexes/distributed_checkpoint.h>
#include <CGAL/Mesh_files/checkpoint.h>
#ifdef DSC_WITH_SCOTCH
#include <CGAL/Distributed_complexes/Scotch_partitioner.h>
#endif

#include <CLI/CLI.hpp>

namespace {

/// Divides a complex among the processes again if their work differs.
void divide(dsc::Tracked_distributed::Distributed& complex) {
#ifdef DSC_WITH_SCOTCH
  complex.rebalance(DSC::Scotch_partitioner());
#else
  complex.rebalance();
#endif
}

/// All inputs in space, whose complexes are distributed among processes.
class Shared_inputs : public dsc::All_inputs
{
public:
  explicit Shared_inputs(DSC::Communicator& processes) : m_processes(processes) {}

  std::unique_ptr<dsc::Tracked_complex> start(const dsc::Run_options& options,
                                              dsc::Repairs& repairs) const override {
    return distributed([&] { return dsc::All_inputs::start(options, repairs); });
  }

  /// Reads a checkpoint of several processes, or of one process.
  std::unique_ptr<dsc::Tracked_complex> resume(const std::string& path,
                                               std::string& metadata) const override {
    std::error_code error;
    const bool is_of_one =
        std::filesystem::is_regular_file(path, error) && CGAL::IO::checkpoint_dimension(path) != 0;
    if (m_processes.reduced(DSC::Communicator::Operation::maximum, is_of_one ? 1 : 0) == 0) {
      auto result = std::make_unique<dsc::Tracked_distributed>(m_processes, divide);
      metadata = CGAL::IO::read_checkpoint(path, result->complex);
      result->label_names = dsc::label_names_of(metadata);
      return result;
    }
    auto result = distributed([&] { return dsc::All_inputs::resume(path, metadata); });
    const auto bytes = m_processes.all_gather({metadata.begin(), metadata.end()}).front();
    metadata.assign(bytes.begin(), bytes.end());
    return result;
  }

  /// Throws the error of the first process there, and another one on the other processes.
  void run_once(const std::function<void()>& function) const override {
    std::exception_ptr failure;
    if (m_processes.rank() == 0) {
      try {
        function();
      } catch (...) {
        failure = std::current_exception();
      }
    }
    const bool has_failed =
        m_processes.reduced(DSC::Communicator::Operation::maximum, failure ? 1 : 0) != 0;
    if (failure)
      std::rethrow_exception(failure);
    if (has_failed)
      throw dsc::Input_error("the first process could not start the run");
  }

private:
  /// Distributes a complex that `build()` returns on the first process.
  template <class Build>
  std::unique_ptr<dsc::Tracked_complex> distributed(const Build& build) const {
    std::unique_ptr<dsc::Tracked_complex> built;
    run_once([&] {
      built = build();
      if (built->dimension() == 2)
        throw dsc::Usage_error("complexes in the plane are not available on several processes; "
                               "run dsc without mpirun");
    });
    auto result = std::make_unique<dsc::Tracked_distributed>(m_processes, divide);
    if (built) // the first process writes reports and whole files
      result->label_names = built->label_names;
    const auto* const whole = dynamic_cast<dsc::Tracked_complex_3*>(built.get());
    if (whole != nullptr && whole->carries_arrays())
      dsc::print_note("several processes",
                      "arrays of the input are not used; run dsc without mpirun");
    result->complex.distribute(whole != nullptr ? whole->complex
                                                : dsc::Tracked_complex_3::Complex());
    return result;
  }

  DSC::Communicator& m_processes;
};

} // namespace

int main(int argc, char** argv) {
  int threads = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &threads); // one thread calls MPI
  int code = 0;
  {
    dsc::Mpi_processes processes(true);
    DSC::Mpi_communicator communicator;
    const Shared_inputs inputs(communicator);
    code = dsc::run_program(argc, argv, [&](CLI::App& app, int& exit_code) {
      processes.require_same_command(argc, argv);
      dsc::add_flows(app, inputs, exit_code);
    });
    processes.end(code);
  }
  MPI_Finalize();
  return code;
}
