// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_MPI_PROCESSES_H
#define DSC_MPI_PROCESSES_H

#include "programs/errors.h"
#include "programs/interrupt.h"
#include "programs/launcher.h"

#include <mpi.h>

#include <cstdio>
#include <sstream>
#include <thread>

namespace dsc {

/// Returns the rank of this process in `MPI_COMM_WORLD`.
inline int rank_of_process() {
  int result = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &result);
  return result;
}

/// The processes of MPI, which must be initialized. Only the first process prints. Another process
/// prints its messages only if it fails and the others do not.
class Mpi_processes : public Process_group
{
public:
  /// \param agrees see `Process_group`
  explicit Mpi_processes(bool agrees) : Process_group(agrees, rank_of_process() == 0) {
    MPI_Comm_dup(MPI_COMM_WORLD, &m_ends);
    MPI_Comm_size(MPI_COMM_WORLD, &m_size);
    if (m_size > 1)
      share_interrupts(*this);
    if (!is_first) {
      std::cerr.rdbuf(m_messages.rdbuf());
      if (std::freopen("/dev/null", "w", stdout) == nullptr)
        std::fclose(stdout);
    }
  }

  /// \throws Usage_error on all processes if they do not run the same command together
  void require_same_command(int argc, char** argv) {
    const Launch launched = launch();
    if (m_size == 1 && launched.processes > 1) {
      char library[MPI_MAX_LIBRARY_VERSION_STRING];
      int length = 0;
      MPI_Get_library_version(library, &length);
      leave_messages_to_first_process();
      throw Usage_error(launched.variable + " is " + std::to_string(launched.processes) +
                        ", but MPI finds one process; use the launcher of the MPI of dsc: " +
                        std::string(library).substr(0, std::string(library).find(',')));
    }
    std::string own;
    for (int i = 1; i < argc; ++i)
      own += std::string(argv[i]) + '\0';
    std::string first = own;
    auto length = int(own.size());
    MPI_Bcast(&length, 1, MPI_INT, 0, MPI_COMM_WORLD);
    first.resize(std::size_t(length));
    MPI_Bcast(first.data(), length, MPI_CHAR, 0, MPI_COMM_WORLD);
    int other = own == first ? m_size : rank_of_process();
    MPI_Allreduce(MPI_IN_PLACE, &other, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
    if (other < m_size)
      throw Usage_error("process " + std::to_string(other) +
                        " has another command line than process 0; start all with the same one");
  }

  bool any(bool value) override {
    int result = value;
    MPI_Allreduce(MPI_IN_PLACE, &result, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    return result != 0;
  }

  bool all_fail() override { return m_all_fail = wait_for_others(in_step, false) == in_step; }

  /// Waits until all processes end. If this process fails and others do not end, ends all of them.
  /// Prints the messages of this process if the others do not fail.
  /// \param code the exit code of this process
  void end(int code) {
    ignore_signals(); // mpirun sends them to all processes after the first one failed
    std::cerr.rdbuf(m_terminal);
    // After an interrupt or an error that all processes meet, the first one can write for long.
    const bool is_common =
        code == exit_code_of_interrupt ? interrupted() : m_all_fail && !library_agrees;
    const Failure least = wait_for_others(code != 0 ? at_end : none, is_common);
    if (code != 0 && least == none && !is_first) {
      const std::string messages = m_messages.str(), begin = "dsc: ";
      const std::size_t last = messages.rfind(begin);
      std::cerr << begin << "process " << rank_of_process() << ": "
                << messages.substr(last == messages.npos ? 0 : last + begin.size()) << std::flush;
    }
    if (m_is_alone)
      MPI_Abort(MPI_COMM_WORLD, code);
    MPI_Comm_free(&m_ends);
  }

private:
  enum Failure { none, at_end, in_step };

  /// Waits until all processes call this function, and returns the least failure. If this process
  /// fails alone, the others wait for it elsewhere. After two seconds, returns `none` then, so that
  /// all processes end within five seconds: `mpirun` needs two seconds to end them.
  Failure wait_for_others(Failure own, bool is_common) {
    if (m_is_alone)
      return none;
    const auto patience = std::chrono::seconds(is_common ? 300 : 2);
    const auto begin = std::chrono::steady_clock::now();
    m_least = own;
    MPI_Request request;
    MPI_Iallreduce(MPI_IN_PLACE, &m_least, 1, MPI_INT, MPI_MIN, m_ends, &request);
    for (int have_arrived = 0;;) {
      MPI_Test(&request, &have_arrived, MPI_STATUS_IGNORE);
      if (have_arrived != 0)
        return Failure(m_least);
      m_is_alone = own != none && std::chrono::steady_clock::now() - begin > patience;
      if (m_is_alone)
        return none;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }

  MPI_Comm m_ends = MPI_COMM_NULL; // other messages of the processes do not reach it
  int m_size = 1;
  int m_least = none; // MPI writes it later than the function returns
  bool m_all_fail = false, m_is_alone = false;
  std::ostringstream m_messages; // of this process, if it is not the first one
  std::streambuf* const m_terminal = std::cerr.rdbuf();
};

} // namespace dsc

#endif // DSC_MPI_PROCESSES_H
