// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_CHECK_IMAGE_H
#define DSC_CHECK_IMAGE_H

#include <string>

namespace dsc {

/// Checks whether an image of voxels (.inr, .inr.gz) can be read, and prints its unused contents.
/// \throws Input_error with the cause if the image cannot be read
void check_image(const std::string& path);

} // namespace dsc

#endif // DSC_CHECK_IMAGE_H
