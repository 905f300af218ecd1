// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/tracked_checkpoint.h"

#include "motions/saved_arrays.h"
#include "motions/tracked_complex_3.h"

#include <CGAL/Mesh_files/checkpoint.h>

namespace dsc {

int checkpoint_dimension(const std::string& path) {
  if (CGAL::IO::is_distributed_checkpoint(path))
    throw Input_error(path + " was written by several processes: resume it with mpirun, such as "
                             "mpirun -n 1 dsc");
  return CGAL::IO::checkpoint_dimension(path);
}

std::unique_ptr<Tracked_complex> track_checkpoint_3(const std::string& path,
                                                    std::string& metadata) {
  auto tracked = restored<Tracked_complex_3>(path, CGAL::IO::read_checkpoint(path), metadata);
  tracked->carry(take_arrays(metadata));
  return tracked;
}

} // namespace dsc
