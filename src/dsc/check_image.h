// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_CHECK_IMAGE_H
#define DSC_CHECK_IMAGE_H

#include <cstddef>
#include <string>

namespace dsc {

/// Checks whether an image of voxels (.inr, .inr.gz) can be read, and prints its unused contents.
/// \param most_channels largest number of values of a voxel
/// \throws Input_error with the cause if the image cannot be read
void check_image(const std::string& path, std::size_t most_channels = 1);

} // namespace dsc

#endif // DSC_CHECK_IMAGE_H
