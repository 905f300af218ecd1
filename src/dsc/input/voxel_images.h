// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_VOXEL_IMAGES_H
#define DSC_VOXEL_IMAGES_H

#include "programs/errors.h"

#include <CGAL/Complex_construction/sample_labels.h>
#include <CGAL/Image_segmentation/Gray_image.h>

#include <CGAL/Image_3.h>

#include <map>

namespace dsc {

/// Reads an image of voxels (.inr, .inr.gz), and prints its unused contents.
/// \throws Input_error with the cause if the image cannot be read
CGAL::Image_3 read_inr(const std::string& path, std::size_t most_channels = 1);

/// Returns the centers of the voxels.
DSC::Sampling_grid<3> grid_of(const CGAL::Image_3& image);

/// Reads the labels of an image of voxels (.inr, .inr.gz), the first axis fastest. Returns the
/// centers of the voxels. \throws Input_error if it cannot be read
DSC::Sampling_grid<3> read_label_image(const std::string& path, std::vector<int>& labels);

/// Statistics of an image.
struct Image_statistics
{
  DSC::Sampling_grid<3> grid;        ///< centers of the voxels
  std::map<int, std::size_t> voxels; ///< number of voxels of each label
};

/// Returns the statistics of an image of voxels (.inr, .inr.gz).
/// \throws Input_error if it cannot be read
Image_statistics image_statistics(const std::string& path);

/// An image with numeric values. In the plane, it has a single layer.
struct Read_image
{
  DSC::Gray_image<3> image;
  std::size_t number_without_values = 0; ///< pixels that are not a number; the mask leaves them out

  bool is_planar() const { return image.grid.size[2] == 1; }
};

/// Reads an image with numeric values in any format of `dsc-files`, or .inr, .inr.gz.
/// \param has_channels whether colors keep their channels; otherwise they become gray values
/// \throws Input_error if it cannot be read
Read_image read_gray_image(const std::string& path, bool has_channels);

/// Returns the layer of a planar image.
DSC::Gray_image<2> layer_of(Read_image image);

/// Writes labels of pixels as an image: .inr, .mha, .nii, .nii.gz, .tif, .vti, .vtk; a single layer
/// also as .png.
/// \param grid the centers of the pixels
/// \param labels a label for each pixel, the first axis fastest
/// \param like image whose axes the new image gets; empty for the axes of space
/// \throws Input_error if the file cannot be written, or there is no program `dsc-files`
void write_label_image(const std::string& path, const DSC::Sampling_grid<3>& grid,
                       const std::vector<int>& labels, const std::string& like = "");

} // namespace dsc

#endif // DSC_VOXEL_IMAGES_H
