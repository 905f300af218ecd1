// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "inr_image.h"

#include "check_image.h"
#include "errors.h"

namespace dsc {

CGAL::Image_3 read_inr(const std::string& path, std::size_t most_channels) {
  check_image(path, most_channels);
  CGAL::Image_3 image;
  if (!image.read(path))
    throw Input_error("cannot read '" + path + "' as a voxel image; check its format");
  return image;
}

CGAL::Deformable_simplicial_complexes::Sampling_grid<3> grid_of(const CGAL::Image_3& image) {
  return {{image.xdim(), image.ydim(), image.zdim()},
          {image.vx(), image.vy(), image.vz()},
          {image.tx(), image.ty(), image.tz()}};
}

} // namespace dsc
