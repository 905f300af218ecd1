// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "interrupt.h"

#include <csignal>

namespace dsc {
namespace {

volatile std::sig_atomic_t flag = 0;

extern "C" void raise_flag(int) { flag = 1; }

} // namespace

void catch_interrupts() {
  struct sigaction action = {};
  action.sa_handler = raise_flag;
  sigemptyset(&action.sa_mask);
  // SA_RESETHAND: whoever asks twice does not want to wait for the step.
  action.sa_flags = SA_RESTART | SA_RESETHAND;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() { return flag != 0; }

} // namespace dsc
