// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "programs/interrupt.h"

#include "output/progress_line.h"

#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <ctime>

namespace dsc {
namespace {

volatile std::sig_atomic_t flag = 0;
timespec time_of_first = {};
Process_group* group = nullptr; // null if interrupts are not shared
bool have_agreed = false;       // to stop

// The signals that ask the program to end. Batch systems announce the end of a job by the last
// three.
constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGUSR2, SIGXCPU};

constexpr char advice[] =
    "dsc: stopping; if no line follows, mpirun ended the processes before they wrote a checkpoint: "
    "stop them by the signal USR1 to mpirun, or use mpirun --mca odls_base_sigkill_timeout 30\n";

// Raises the flag at the first signal. A later signal ends the program at once. Signals that follow
// within a second are ignored, because timeout(1) and some shells send the same signal to the
// program and to its process group. Launchers repeat signals, and kill processes themselves.
extern "C" void raise_flag(int signal) {
  timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  if (flag == 0) {
    flag = 1;
    time_of_first = now;
    if (group != nullptr && group->is_first && write(STDERR_FILENO, advice, sizeof advice - 1) < 0)
      return; // the terminal is closed
  } else if (group == nullptr && now.tv_sec > time_of_first.tv_sec + 1) {
    std::signal(signal, SIG_DFL);
    raise(signal);
  }
}

} // namespace

void catch_signals() {
  struct sigaction action = {};
  action.sa_handler = raise_flag;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  for (const int number : signals)
    sigaction(number, &action, nullptr);
  for (const int number : {SIGXFSZ, SIGPIPE})
    std::signal(number, SIG_IGN);
}

void ignore_signals() {
  for (const int number : signals)
    std::signal(number, SIG_IGN);
}

bool interrupted() { return group != nullptr ? have_agreed : flag != 0; }

void share_interrupts(Process_group& processes) { group = &processes; }

void agree_on_interrupts() {
  if (group != nullptr)
    have_agreed = group->any(flag != 0);
}

bool all_processes_fail() { return group == nullptr || group->all_fail(); }

Interruptible::Interruptible(bool quiet)
    : m_shows(!quiet && shows_lines()),
      m_scope([this](const char* phase) { return go_on(phase); }) {}

Interruptible::~Interruptible() {
  if (m_shown)
    std::fputs("\r\033[K", stderr);
}

bool Interruptible::go_on(const char* phase) {
  const Clock::time_point now = Clock::now();
  if (m_shows && now >= m_next) {
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(now - m_start).count();
    std::fprintf(stderr, "\r\033[K%s, %ld s", phase, long(seconds));
    std::fflush(stderr);
    m_shown = true;
    m_next = now + std::chrono::seconds(1);
  }
  return group != nullptr && group->library_agrees ? flag == 0 : !interrupted();
}

} // namespace dsc
