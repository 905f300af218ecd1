// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "interrupt.h"

#include <csignal>
#include <ctime>

namespace dsc {
namespace {

volatile std::sig_atomic_t flag = 0;
timespec time_of_first = {};

// Whoever asks twice does not want to wait for the step; but timeout(1) and some shells send the
// same signal to the program and to its process group.
extern "C" void raise_flag(int signal) {
  timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  if (flag == 0) {
    flag = 1;
    time_of_first = now;
  } else if (now.tv_sec > time_of_first.tv_sec + 1) {
    std::signal(signal, SIG_DFL);
    raise(signal);
  }
}

} // namespace

void catch_interrupts() {
  struct sigaction action = {};
  action.sa_handler = raise_flag;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() { return flag != 0; }

} // namespace dsc
