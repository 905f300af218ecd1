// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Image_segmentation, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IMAGE_SEGMENTATION_SEGMENTATION_OPTIONS_H
#define CGAL_IMAGE_SEGMENTATION_SEGMENTATION_OPTIONS_H

#include <CGAL/license/Image_segmentation.h>

#include <CGAL/Deformable_simplicial_complexes/exceptions.h>

#include <cmath>
#include <optional>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgImageSegmentationRef

Options of `segment_image()`. Lengths are in pixels: in units of the cubic root of the volume of a
voxel, in the plane of the square root of the area of a pixel.

\tparam d the dimension, 2 or 3
*/
template <int d> struct Segmentation_options
{
  /// Number of phases, at least 2. Their intensities are estimated.
  unsigned phases = 2;
  /// Intensities of the phases, one for each channel, instead of the number of phases. They stay.
  std::vector<std::vector<double>> intensities;
  /// Standard deviation of the noise of each channel. If empty, it is estimated.
  std::vector<double> noise;
  /// Energy of the interface per area of a side of a voxel, in the plane per side of a pixel, in
  /// squares of the noise; positive. A ball or disk with a radius below twice this number, divided
  /// by its squared contrast in units of the noise, vanishes. By default, it is the smallest
  /// squared contrast, with more than two phases twice as much, and at least 2.5 times the smallest
  /// contrast (in space 1.2 times), in units of the noise.
  std::optional<double> smoothing;
  /// \var longest_edge
  /// Length of edges at the beginning
  /// \var shortest_edge
  /// Target length of edges of the interface at the end. Both are at least 1.
  double longest_edge = d == 2 ? 5 : 10, shortest_edge = d == 2 ? 2.5 : 3;
  /// Whether the topology stays as it is after the labels of the first mesh, or that of the given
  /// complex.
  bool keeps_topology = false;
  /// Labels of which only the largest component stays.
  std::vector<int> connected;
  /// Number of threads if linked with TBB. The result does not depend on it.
  unsigned number_of_threads = 1;

  /// Throws an exception unless all values are in their ranges.
  /// \throws Error if a value is out of its range
  void check() const {
    if ((intensities.empty() ? phases : intensities.size()) < 2)
      throw Error("the number of phases is too small: use 2 or more");
    for (const auto& intensity : intensities)
      for (const double x : intensity)
        if (!std::isfinite(x) || intensity.size() != intensities.front().size())
          throw Error("the intensities of the phases are not finite, or do not have one number for "
                      "each channel");
    for (const double x : noise)
      if (!(x > 0) || !std::isfinite(x))
        throw Error("the noise is out of range: use positive, finite numbers");
    if (smoothing && !(*smoothing > 0 && std::isfinite(*smoothing)))
      throw Error("the smoothing is out of range: use a positive, finite number");
    if (!(shortest_edge >= 1 && longest_edge >= shortest_edge) || !std::isfinite(longest_edge))
      throw Error("the lengths of edges are out of range: use 1 or more, and the longest edge at "
                  "least as long as the shortest one");
  }
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_IMAGE_SEGMENTATION_SEGMENTATION_OPTIONS_H
