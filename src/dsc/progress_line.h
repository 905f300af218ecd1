// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_PROGRESS_LINE_H
#define DSC_PROGRESS_LINE_H

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace dsc {

/// One line on the terminal that is overwritten after every step, with an estimate of the
/// remaining time. Shows nothing if stderr is not a terminal.
class Progress_line
{
public:
  /// \param unit what steps are called
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

/// A line on the terminal that tells for how long what cannot be counted has taken. Shows nothing
/// if stderr is not a terminal.
class Waiting_line
{
public:
  Waiting_line(const std::string& what, bool quiet);
  ~Waiting_line() { clear(); }
  Waiting_line(const Waiting_line&) = delete;
  Waiting_line& operator=(const Waiting_line&) = delete;

  /// Removes the line.
  void clear();

private:
  void show_each_second(const std::string& what);

  std::mutex m_mutex;
  std::condition_variable m_cleared;
  bool m_is_clear = false;
  std::thread m_thread; // last, as it uses the others
};

} // namespace dsc

#endif // DSC_PROGRESS_LINE_H
