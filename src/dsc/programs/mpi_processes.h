// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_MPI_PROCESSES_H
#define DSC_MPI_PROCESSES_H

#include "programs/interrupt.h"

#include <mpi.h>

#include <chrono>
#include <cstdio>
#include <iostream>
#include <sstream>
#include <thread>

namespace dsc {

/// Returns the rank of this process in `MPI_COMM_WORLD`.
inline int rank_of_process() {
  int result = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &result);
  return result;
}

/// Returns whether the argument is `true` in at least one process.
inline bool any_process(bool value) {
  int result = value;
  MPI_Allreduce(MPI_IN_PLACE, &result, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  return result != 0;
}

/// Redirects messages: only the first process prints. Another process prints its messages only if
/// it fails and the others do not end. MPI must be initialized.
class Mpi_processes
{
public:
  /// \param library_agrees see `share_interrupts()`
  explicit Mpi_processes(bool library_agrees) {
    MPI_Comm_dup(MPI_COMM_WORLD, &m_ends);
    int number = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &number);
    if (number > 1)
      share_interrupts(any_process, library_agrees);
    if (rank_of_process() != 0) {
      std::cerr.rdbuf(m_messages.rdbuf());
      if (std::freopen("/dev/null", "w", stdout) == nullptr)
        std::fclose(stdout);
    }
  }

  /// Waits until all processes end. If this process fails and others do not end, ends all of them
  /// after printing the messages of this process.
  /// \param code the exit code of this process
  void end(int code) {
    std::cerr.rdbuf(m_terminal);
    // The first process prints its message itself. It can take long to write files after an error
    // or an interrupt that all processes meet.
    const auto patience =
        std::chrono::seconds(rank_of_process() == 0 && code != exit_code_of_interrupt ? 5 : 300);
    const auto begin = std::chrono::steady_clock::now();
    MPI_Request request;
    MPI_Ibarrier(m_ends, &request);
    for (int have_ended = 0;;) {
      MPI_Test(&request, &have_ended, MPI_STATUS_IGNORE);
      if (have_ended != 0)
        break;
      if (code != 0 && std::chrono::steady_clock::now() - begin > patience) {
        std::fputs(m_messages.str().c_str(), stderr);
        MPI_Abort(MPI_COMM_WORLD, code);
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    MPI_Comm_free(&m_ends);
  }

private:
  MPI_Comm m_ends = MPI_COMM_NULL; // other messages of the processes do not reach it
  std::ostringstream m_messages;   // of this process, if it is not the first one
  std::streambuf* const m_terminal = std::cerr.rdbuf();
};

} // namespace dsc

#endif // DSC_MPI_PROCESSES_H
