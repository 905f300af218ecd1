// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tracked_checkpoint.h"

#include "tracked_complex_3.h"

#include <CGAL/Deformable_simplicial_complexes/IO/checkpoint.h>
#include <CGAL/Deformable_simplicial_complexes/IO/is_distributed_checkpoint.h>

#include <stdexcept>

namespace dsc {

std::unique_ptr<Tracked_complex> track_checkpoint(const std::string& path, std::string& metadata) {
  if (CGAL::IO::is_distributed_checkpoint(path))
    throw std::runtime_error(path +
                             " was written by several processes: resume it with mpirun, such as "
                             "mpirun -n 1 dsc");
  if (CGAL::IO::checkpoint_dimension(path) == 2)
    return track_planar_checkpoint(path, metadata);
  return restored<Tracked_complex_3>(path, CGAL::IO::read_checkpoint(path), metadata);
}

} // namespace dsc
