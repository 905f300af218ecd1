// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_RUN_H
#define DSC_RUN_H

#include "motion.h"
#include "run_start.h"

#include <array>
#include <optional>
#include <set>
#include <string>

namespace dsc {

/// The files that a run writes, and whether it prints its progress and result.
struct Output_options
{
  std::string folder;   ///< empty for no files
  unsigned every = 1;   ///< of so many steps
  int subdivisions = 0; ///< for smooth surfaces there, by Loop's scheme; none if 0
  std::string picture;  ///< file; empty for none
  std::string report;   ///< file; empty for none
  bool quiet = false;
};

/// What the commands that move an interface are asked to do.
struct Run_options
{
  Step_options step;
  std::set<std::string> given;                 ///< names of the options in the command line
  Run_start start;                             ///< empty if `resume` is set
  std::string resume;                          ///< a checkpoint
  std::optional<std::array<double, 6>> domain; ///< of the input's coordinates: least, largest ones
  unsigned steps = 10;                         ///< to do in this run
  unsigned threads = 1;                        ///< to use
  Output_options output;
};

/// Moves an interface, and returns the exit code of the program. \throws std::runtime_error with a
/// message of one line that says what is wrong and what to do
int run(const Run_options& options);

} // namespace dsc

#endif // DSC_RUN_H
