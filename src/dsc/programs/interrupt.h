// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_INTERRUPT_H
#define DSC_INTERRUPT_H

#include "programs/errors.h"

#include <CGAL/Mesh_support/Progress_scope.h>

#include <chrono>

namespace dsc {

constexpr int exit_code_of_interrupt = 130; ///< exit code of shells for SIGINT

/// Installs the signal handlers. The first SIGINT, SIGTERM or SIGHUP only raises a flag; another
/// one some seconds later ends the program. Files that grow too large and closed pipes make write
/// operations fail, and no longer end the program.
void catch_signals();

/// Returns whether the flag is raised. If interrupts are shared, returns the result of the last
/// call of `agree_on_interrupts()` instead.
bool interrupted();

/// Shares interrupts between processes that run the same program, which must stop at the same
/// place.
/// \param any returns whether the argument is `true` in at least one process. All processes call it
/// together.
/// \param library_agrees whether functions of the package stop in all processes if one of them is
/// interrupted. Otherwise, they stop only after `agree_on_interrupts()`.
void share_interrupts(bool (*any)(bool), bool library_agrees);

/// Asks all processes for their flags if interrupts are shared. All processes call it together.
void agree_on_interrupts();

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
