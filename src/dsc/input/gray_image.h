// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_GRAY_IMAGE_H
#define DSC_GRAY_IMAGE_H

#include <CGAL/Image_segmentation/Gray_image.h>

#include <cstddef>
#include <string>

namespace dsc {

/// An image with numeric values. In the plane, it has a single layer.
struct Read_image
{
  CGAL::Deformable_simplicial_complexes::Gray_image<3> image;
  std::size_t number_without_values = 0; ///< pixels that are not a number; the mask leaves them out

  bool is_planar() const { return image.grid.size[2] == 1; }
};

/// Reads an image with numeric values in any format of `dsc-files`, or .inr, .inr.gz.
/// \param has_channels whether colors keep their channels; otherwise they become gray values
/// \throws Input_error if it cannot be read
Read_image read_gray_image(const std::string& path, bool has_channels);

/// Returns the layer of a planar image.
CGAL::Deformable_simplicial_complexes::Gray_image<2> layer_of(Read_image image);

} // namespace dsc

#endif // DSC_GRAY_IMAGE_H
