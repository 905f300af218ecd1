// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_CONVERT_FILE_H
#define DSC_CONVERT_FILE_H

#include "programs/errors.h"

#include <CGAL/Complex_construction/sample_labels.h>

#include <cstddef>
#include <map>
#include <string>

namespace dsc {

/// Statistics of an image.
struct Image_statistics
{
  DSC::Sampling_grid<3> grid;        ///< centers of the voxels
  std::map<int, std::size_t> voxels; ///< number of voxels of each label
};

/// Reads an image (.inr, .inr.gz).
/// \throws Input_error if it cannot be read
Image_statistics image_statistics(const std::string& path);

/// Converts a file that is no checkpoint: a surface into another surface format, tetrahedra into
/// tetrahedra or their interface, an image into another image format, curves into regions.
/// \param labels, thresholds as in `Run_start`
/// \throws Input_error if the file cannot be read or written
/// \throws Usage_error if the format of the output does not fit the content
void convert_file(const std::string& input, const std::string& output, const std::string& labels,
                  const std::string& thresholds);

/// Writes the labels of a complex in a checkpoint as an image.
/// \param grid image with the voxels
/// \throws Input_error if a file cannot be read or written
void convert_to_image(const std::string& checkpoint, const std::string& output,
                      const std::string& grid);

} // namespace dsc

#endif // DSC_CONVERT_FILE_H
