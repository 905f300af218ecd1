// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "programs/threads_option.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <thread>

#include <sched.h>

namespace dsc {
namespace {

constexpr unsigned most_threads = 1024;

} // namespace

unsigned default_number_of_threads() {
  // mpirun and batch systems bind a process to some of the cores.
  cpu_set_t cores;
  if (sched_getaffinity(0, sizeof(cores), &cores) == 0)
    return std::clamp(unsigned(CPU_COUNT(&cores)), 1u, most_threads);
  return std::clamp(std::thread::hardware_concurrency(), 1u, most_threads); // 0 if unknown
}

void add_threads_option(CLI::App& command, unsigned& threads) {
  command
      .add_option("--threads", threads,
                  "Number of threads (default: all cores); the result does not depend on it")
      ->check(CLI::Range(1u, most_threads));
}

} // namespace dsc
