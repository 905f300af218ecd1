// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "files.h"
#include "tracked_complex.h"

#include <iostream>

namespace dsc {

int execute(const Convert_options& options) {
  require_writable(options.output);
  std::string metadata;
  const Tracked_complex complex = Tracked_complex::from_checkpoint(options.checkpoint, metadata);
  const std::string format = extension(options.output);
  if (format == "vtu")
    complex.write_volume_vtu(options.output);
  else if (format == "mesh")
    complex.write_mesh(options.output);
  else
    complex.write_interface(options.output);
  if (!options.quiet)
    std::cout << "dsc: wrote " << options.output << '\n';
  return 0;
}

} // namespace dsc
