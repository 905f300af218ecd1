// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_IMAGE_SEGMENTATION_GRAY_IMAGE_H
#define CGAL_IMAGE_SEGMENTATION_GRAY_IMAGE_H

#include <CGAL/Complex_construction/sample_labels.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <cstdint>
#include <string>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgImageSegmentationRef

An image of numbers: gray values, or several channels. Pixels (in space: voxels) are boxes around
the points of a grid.

\tparam d the dimension, 2 or 3
*/
template <int d> struct Gray_image
{
  Sampling_grid<d> grid;                    ///< the centers of the pixels
  std::vector<std::vector<float>> channels; ///< values of each channel, the first axis fastest
  std::vector<std::uint8_t> mask; ///< 0 for pixels without a value; empty if all pixels have one

  /// Returns the side of a square or a cube with the measure of a pixel.
  double side() const {
    double measure = 1;
    for (const double x : grid.spacing)
      measure *= x;
    return std::pow(measure, 1. / d);
  }

  /// Returns whether a pixel has a value.
  bool has_value(std::size_t pixel) const { return mask.empty() || mask[pixel] != 0; }

  /// Throws an exception unless the image can be used. Linear.
  /// \throws Error if the grid is not valid, there is no channel or no pixel with a value, a size does
  ///         not fit the grid, a value is not finite, or the origin is farther than 1e9 pixels
  void check() const {
    static constexpr double farthest = 1e9; // sides of a pixel, which doubles resolve
    const std::size_t n = grid.number_of_points();
    for (int axis = 0; axis < d; ++axis)
      if (!(std::abs(grid.origin[axis]) <= farthest * grid.spacing[axis]))
        throw Error("the origin of the image is too far away for the size of its pixels: move the "
                    "image");
    if (channels.empty())
      throw Error("the image has no channel: add the values of its pixels");
    for (const auto& channel : channels)
      if (channel.size() != n)
        throw Error("a channel of the image has " + std::to_string(channel.size()) +
                    " values, but the grid has " + std::to_string(n) + " points");
    if (!mask.empty() && mask.size() != n)
      throw Error("the mask of the image has " + std::to_string(mask.size()) +
                  " values, but the grid has " + std::to_string(n) + " points");
    bool is_empty = true;
    for (std::size_t i = 0; i < n; ++i) {
      Progress_scope::check();
      if (!has_value(i))
        continue;
      is_empty = false;
      for (const auto& channel : channels)
        if (!std::isfinite(channel[i]))
          throw Error("the value of pixel " + std::to_string(i) +
                      " is not finite: leave such pixels out by the mask");
    }
    if (is_empty)
      throw Error(
          "the mask of the image leaves out all pixels: use a mask that is not 0 somewhere");
  }
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_IMAGE_SEGMENTATION_GRAY_IMAGE_H
