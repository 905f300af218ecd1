// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FILES_WRITE_IMAGE_H
#define DSC_FILES_WRITE_IMAGE_H

#include "Translation.h"
#include "read_dataset.h"

#include <vtkImageData.h>

namespace dsc_files {

/// Writes an image as labels of voxels (`image.inr`) or, if it has a single layer, of pixels
/// (`image.pgm`). Labels are the values of the image, gray values between thresholds, or the colors
/// in the order of their values.
/// An image whose axes are rotated in space is written along its own axes.
/// \throws Failure if the values are no labels
Translation write_image(vtkImageData* image, const Options& options);

/// Writes the values of an image as numbers (`image.inr`), several channels beside each other.
/// \param options `values` tells whether colors become gray values
Translation write_channels(vtkImageData* image, const Options& options);

} // namespace dsc_files

#endif // DSC_FILES_WRITE_IMAGE_H
