// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_INTERRUPT_H
#define DSC_INTERRUPT_H

#include "programs/errors.h"

#include <CGAL/Mesh_support/Progress_scope.h>

namespace dsc {

constexpr int exit_code_of_interrupt = 130; ///< exit code of shells for SIGINT

/// Processes that run the same program, which must stop at the same place.
class Process_group
{
public:
  /// \param agrees whether functions of the package stop in all processes if one of them is
  /// interrupted. Otherwise, they stop only after `agree_on_interrupts()`.
  /// \param first whether this process prints messages for all
  Process_group(bool agrees, bool first) : library_agrees(agrees), is_first(first) {}
  virtual ~Process_group() = default;

  /// Returns whether the argument is `true` in at least one process. Collective.
  virtual bool any(bool value) = 0;

  /// See `all_processes_fail()`.
  virtual bool all_fail() = 0;

  const bool library_agrees, is_first;
};

/// Installs the signal handlers. The first signal that asks the program to end only raises a flag;
/// another one some seconds later ends the program. Files that grow too large and closed pipes make
/// write operations fail, and no longer end the program.
void catch_signals();

/// Ignores signals that ask the program to end from now on: it has nothing left to stop.
void ignore_signals();

/// Returns whether the flag is raised. If interrupts are shared, returns the result of the last
/// call of `agree_on_interrupts()` instead.
bool interrupted();

/// Shares interrupts and errors between processes. The first signal prints what to do if the
/// launcher kills the processes too early. Further signals are ignored.
void share_interrupts(Process_group& group);

/// Asks all processes for their flags if interrupts are shared. All processes call it together.
void agree_on_interrupts();

/// Waits for the other processes after an error in a time step, for some seconds at most. Returns
/// whether all of them have an error in a step, so that they can save the previous one together.
bool all_processes_fail();

/// A scope in which functions of the package throw Interrupted_error after the flag is raised. On a
/// terminal, a line names phases that take longer than a second.
class Interruptible
{
public:
  /// \param quiet whether the line is suppressed
  explicit Interruptible(bool quiet);
  ~Interruptible();

private:
  bool go_on(const char* phase);

  using Clock = std::chrono::steady_clock;

  bool m_shows;
  bool m_shown = false;
  Clock::time_point m_start = Clock::now(), m_next = m_start + std::chrono::seconds(1);
  DSC::Progress_scope m_scope;
};

} // namespace dsc

#endif // DSC_INTERRUPT_H
