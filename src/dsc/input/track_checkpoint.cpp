// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/tracked_checkpoint.h"

#include "motions/saved_arrays.h"
#include "motions/tracked_complex_3.h"

#include <CGAL/Mesh_files/checkpoint.h>

#include <utility>

namespace dsc {

int checkpoint_dimension(const std::string& path) {
  if (CGAL::IO::is_distributed_checkpoint(path))
    throw Input_error(path + " was written by several processes: resume it with mpirun, such as "
                             "mpirun -n 1 dsc");
  return CGAL::IO::checkpoint_dimension(path);
}

std::unique_ptr<Tracked_complex> track_checkpoint_3(const std::string& path,
                                                    std::string& metadata) {
  auto checkpoint = CGAL::IO::read_checkpoint(path);
  DSC::Mesh_arrays arrays = take_arrays(checkpoint.metadata);
  auto tracked = restored<Tracked_complex_3>(path, std::move(checkpoint), metadata);
  tracked->carry(std::move(arrays));
  return tracked;
}

} // namespace dsc
