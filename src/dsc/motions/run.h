// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_RUN_H
#define DSC_RUN_H

#include "input/run_start.h"
#include "input/surface.h"
#include "motions/motion.h"

#include <set>

namespace dsc {

class Inputs;

/// The output files of a run, and whether progress and result are printed.
struct Output_options
{
  std::string folder;   ///< empty for no files
  unsigned every = 1;   ///< number of steps between written states
  int subdivisions = 0; ///< of the smooth surfaces in the output, by Loop's scheme; 0 for none
  std::string picture;  ///< file; empty for none
  std::string report;   ///< file; empty for none
  bool quiet = false;
};

/// The options of the commands that move an interface.
struct Run_options
{
  const Inputs* inputs = nullptr; ///< of the program
  Step_options step;
  std::set<std::string> given;                 ///< names of the options in the command line
  Run_start start;                             ///< empty if `resume` is set
  std::string resume;                          ///< checkpoint file
  std::optional<std::array<double, 6>> domain; ///< lower, upper bounds in input coordinates
  unsigned steps = 10;                         ///< number of steps of this run
  unsigned threads = 1;                        ///< number of threads
  Output_options output;
};

/// Moves an interface. Returns the exit code of the program.
/// \throws std::runtime_error with a message of one line that states the cause and what to do
int run(const Run_options& options);

} // namespace dsc

#endif // DSC_RUN_H
