// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/surface.h"
#include "input/unused.h"

#include <CGAL/Mesh_files/labeled_surface_3.h>

namespace dsc {

std::vector<Surface> read_surfaces(const std::vector<std::string>& paths) {
  std::vector<Surface> surfaces;
  for (const std::string& path : paths) {
    Unused_content unused;
    surfaces.push_back(CGAL::IO::read_labeled_surface<Surface_point>(
        path, static_cast<int>(surfaces.size()) + 1, &unused));
    print_unused(path, unused);
  }
  return surfaces;
}

} // namespace dsc
