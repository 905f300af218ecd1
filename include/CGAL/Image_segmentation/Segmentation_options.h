// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_IMAGE_SEGMENTATION_SEGMENTATION_OPTIONS_H
#define CGAL_IMAGE_SEGMENTATION_SEGMENTATION_OPTIONS_H

#include <CGAL/Mesh_support/Error.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

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
  /// Intensities of the phases, one for each channel, instead of the number of phases. They do not
  /// change. Labels are their indices.
  std::vector<std::vector<double>> intensities;
  /// Standard deviation of the noise of each channel. If empty, it is estimated.
  std::vector<double> noise;
  /// Energy of the interface per area of a side of a voxel, in the plane per side of a pixel, in
  /// squares of the noise; positive. Let \f$\alpha\f$ be the smoothing and \f$\Delta\f$ a contrast
  /// in units of the noise. A disk with a radius below \f$2\alpha/\Delta^2\f$ vanishes, and a ball
  /// with a radius below \f$3\alpha/\Delta^2\f$. The default is \f$\Delta^2\f$ for the smallest
  /// contrast, and
  /// \f$2\Delta^2\f$ with more than two phases. It is at least \f$2.5\Delta\f$, in space
  /// \f$1.2\Delta\f$.
  std::optional<double> smoothing;
  /// \var longest_edge
  /// Length of edges at the beginning
  /// \var shortest_edge
  /// Target length of edges of the interface at the end. Both are at least 1.
  double longest_edge = d == 2 ? 5 : 10, shortest_edge = d == 2 ? 2.5 : 3;
  /// Whether the topology of the first labels, or of the given complex, is preserved.
  bool keeps_topology = false;
  /// Labels of which only the largest component stays. Not together with `keeps_topology`.
  std::vector<int> connected;
  /// Number of threads if linked with TBB. The result does not depend on it.
  unsigned number_of_threads = 1;

  /// Throws an exception unless all values are in their ranges.
  /// \throws Error if a value is out of its range
  void check() const {
    const std::size_t number = intensities.empty() ? phases : intensities.size();
    if (number < 2)
      throw Error("the number of phases is too small: use 2 or more");
    for (const auto& intensity : intensities) {
      for (const double x : intensity)
        if (!std::isfinite(x) || intensity.size() != intensities.front().size())
          throw Error(
              "the intensities of the phases are out of range: give one finite number for each "
              "channel");
      if (std::count(intensities.begin(), intensities.end(), intensity) > 1)
        throw Error("two phases have the same intensities: give different ones");
    }
    for (const int label : connected)
      if (label < 0 || std::size_t(label) >= number)
        throw Error("the label " + std::to_string(label) +
                    " that must stay connected is no index of a phase: use 0 to " +
                    std::to_string(number - 1));
    if (keeps_topology && !connected.empty())
      throw Error(
          "components cannot be removed if the topology stays: give either connected labels "
          "or keep the topology");
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

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_IMAGE_SEGMENTATION_SEGMENTATION_OPTIONS_H
