// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_BENCHMARK_TIME_LIMIT_H
#define DSC_BENCHMARK_TIME_LIMIT_H

#include <csignal>
#include <cstdlib>
#include <string>
#include <utility>

#include <unistd.h>

/// A time limit for each operation of a program that deforms complexes at random.
namespace dsc_benchmark::time_limit {

inline std::string operation; ///< the present one, for messages

extern "C" inline void end_hanging_program(int) {
  static constexpr char text[] = " hangs\n";
  const bool is_told = ::write(STDERR_FILENO, operation.data(), operation.size()) >= 0 &&
                       ::write(STDERR_FILENO, text, sizeof text - 1) >= 0;
  std::_Exit(is_told ? EXIT_FAILURE : 2);
}

/// Starts the time of an operation. If it takes longer than two minutes, the program ends.
inline void begin(std::string name) {
  static constexpr unsigned seconds = 120;
  operation = std::move(name);
  std::signal(SIGALRM, end_hanging_program);
  ::alarm(seconds);
}

inline void end() { ::alarm(0); }

} // namespace dsc_benchmark::time_limit

#endif // DSC_BENCHMARK_TIME_LIMIT_H
