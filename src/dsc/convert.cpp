// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "files.h"
#include "interrupt.h"
#include "tracked_complex.h"

#include <iostream>

namespace dsc {

int execute(const Convert_options& options) {
  require_writable(options.output);
  const Interruptible interruptible(options.quiet);
  std::string metadata;
  const auto complex = track_checkpoint(options.checkpoint, metadata);
  if (options.subdivisions > 0)
    complex->write_subdivided(options.output, options.subdivisions);
  else
    complex->write(options.output);
  if (!options.quiet)
    std::cout << "dsc: wrote " << options.output << '\n';
  return 0;
}

} // namespace dsc
