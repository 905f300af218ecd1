// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_INR_IMAGE_H
#define DSC_INR_IMAGE_H

#include <CGAL/Complex_construction/sample_labels.h>

#include <CGAL/Image_3.h>

#include <cstddef>
#include <string>

namespace dsc {

/// Reads an image of voxels (.inr, .inr.gz), and prints its unused contents, see check_image().
/// \throws Input_error with the cause if the image cannot be read
CGAL::Image_3 read_inr(const std::string& path, std::size_t most_channels = 1);

/// Returns the centers of the voxels.
CGAL::Deformable_simplicial_complexes::Sampling_grid<3> grid_of(const CGAL::Image_3& image);

} // namespace dsc

#endif // DSC_INR_IMAGE_H
