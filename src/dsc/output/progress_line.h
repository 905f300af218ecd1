// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_PROGRESS_LINE_H
#define DSC_PROGRESS_LINE_H

#include <chrono>

namespace dsc {

/// Returns whether stderr is a terminal, on which lines can be overwritten.
bool shows_lines();

/// A line on the terminal that is overwritten after every step, with an estimate of the remaining
/// time. Shows nothing if stderr is not a terminal.
class Progress_line
{
public:
  /// \param unit name of a step
  Progress_line(unsigned steps, bool quiet, const char* unit = "step");
  ~Progress_line() { clear(); }
  Progress_line(const Progress_line&) = delete;
  Progress_line& operator=(const Progress_line&) = delete;

  /// Shows that `done` steps of this run are done.
  void show(unsigned done);

  /// Removes the line.
  void clear();

private:
  unsigned m_steps;
  const char* m_unit;
  bool m_enabled;
  bool m_shown = false;
  std::chrono::steady_clock::time_point m_start;
};

} // namespace dsc

#endif // DSC_PROGRESS_LINE_H
