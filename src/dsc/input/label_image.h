// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_LABEL_IMAGE_H
#define DSC_LABEL_IMAGE_H

#include <CGAL/Complex_construction/sample_labels.h>

#include <string>
#include <vector>

namespace dsc {

/// Writes labels of pixels as an image: .inr, .mha, .nii, .nii.gz, .tif, .vti, .vtk; a single layer
/// also as .png.
/// \param grid the centers of the pixels
/// \param labels a label for each pixel, the first axis fastest
/// \param like image whose axes the new image gets; empty for the axes of space
/// \throws Input_error if the file cannot be written, or there is no program `dsc-files`
void write_label_image(const std::string& path,
                       const CGAL::Deformable_simplicial_complexes::Sampling_grid<3>& grid,
                       const std::vector<int>& labels, const std::string& like = "");

} // namespace dsc

#endif // DSC_LABEL_IMAGE_H
